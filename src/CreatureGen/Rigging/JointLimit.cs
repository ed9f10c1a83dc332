using System;

namespace CreatureGen.Rigging;

/// <summary>A range of angles around a rest position, radians.</summary>
/// <param name="Min">Least angle, not above 0.</param>
/// <param name="Max">Greatest angle, not below 0.</param>
public readonly record struct AngleRange(float Min, float Max)
{
    /// <summary>The range from −<paramref name="angle"/> to <paramref name="angle"/>.</summary>
    public static AngleRange Both(float angle) => new(-angle, angle);

    /// <summary>The range in which every angle has the opposite sign.</summary>
    public AngleRange Negated => new(-Max, -Min);

    /// <summary>The angle of the range nearest to <paramref name="angle"/>.</summary>
    public float Clamp(float angle) => angle < Min ? Min : angle > Max ? Max : angle;

    /// <summary>Both ends, as in <c>-0.5..1.2</c>.</summary>
    public override string ToString() => FormattableString.Invariant($"{Min}..{Max}");
}

/// <summary>
/// Limits of a joint's rotation away from its rest pose, in the axes of its bone (<see cref="BoneAxes"/>). A knee bends far one way and hardly at all the other, so every range has its own two ends.
/// </summary>
/// <param name="SwingX">Turn about the bone's X, the axis of hinges.</param>
/// <param name="SwingZ">Turn about the bone's Z.</param>
/// <param name="Twist">Turn about the bone, its Y.</param>
public sealed record JointLimit(AngleRange SwingX, AngleRange SwingZ, AngleRange Twist)
{
    /// <summary>The same limit both ways about each axis, radians.</summary>
    public JointLimit(float swingX, float swingZ, float twist)
        : this(AngleRange.Both(swingX), AngleRange.Both(swingZ), AngleRange.Both(twist))
    {
    }

    /// <summary>No rotation at all: the joint only slides, or moves nothing.</summary>
    public static JointLimit Fixed { get; } = new(0f, 0f, 0f);

    /// <summary>Any rotation.</summary>
    public static JointLimit Free { get; } = new((float)Maths.PortableMath.Pi, (float)Maths.PortableMath.Pi, (float)Maths.PortableMath.Pi);

    /// <summary>The limit of the joint on the other side of the body, whose frame is the mirror image (local X stays, Y and Z turn the other way).</summary>
    public JointLimit Mirrored() => new(SwingX, SwingZ.Negated, Twist.Negated);
}
