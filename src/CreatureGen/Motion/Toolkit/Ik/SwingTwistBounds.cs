using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>A joint's limit as squares of its ends: whether a turn is certainly within it is told from them by bounds of its angles that cost no inverse function, no root and no division.</summary>
internal readonly struct SwingTwistBounds
{
    /// <summary>2 · asin(1/2) / (1/2), rounded up: below half, no angle is more than so many times the sine of its half.</summary>
    public const float AnglePerHalfSine = 2.0944f;

    /// <summary>The same for half sines below √3/2, of turns up to 120°.</summary>
    private const float WideAnglePerHalfSine = 2.4185f;

    private readonly float minX;
    private readonly float maxX;
    private readonly float minZ;
    private readonly float maxZ;
    private readonly float minTwist;
    private readonly float maxTwist;

    /// <summary>Those of a limit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public SwingTwistBounds(JointLimit limit)
    {
        minX = limit.SwingX.Min * limit.SwingX.Min;
        maxX = limit.SwingX.Max * limit.SwingX.Max;
        minZ = limit.SwingZ.Min * limit.SwingZ.Min;
        maxZ = limit.SwingZ.Max * limit.SwingZ.Max;
        minTwist = limit.Twist.Min * limit.Twist.Min;
        maxTwist = limit.Twist.Max * limit.Twist.Max;
    }

    /// <summary>Those of a part of a limit.</summary>
    public SwingTwistBounds(JointLimit limit, float part)
        : this(new JointLimit(Part(limit.SwingX, part), Part(limit.SwingZ, part), Part(limit.Twist, part)))
    {
    }

    /// <summary>Whether a turn is certainly within, and its swing no more than 60°.</summary>
    /// <param name="turn">Unit quaternion, in the joint's own axes: rest⁻¹ · local.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool HoldSmall(Quaternion turn) => (turn.X * turn.X) + (turn.Z * turn.Z) <= 0.25f && Hold(turn);

    /// <summary>Whether a turn is certainly within.</summary>
    /// <param name="turn">Unit quaternion, in the joint's own axes: rest⁻¹ · local.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Hold(Quaternion turn)
    {
        float along = (turn.Y * turn.Y) + (turn.W * turn.W);
        float across = (turn.X * turn.X) + (turn.Z * turn.Z);
        if (across > 0.75f || turn.Y * turn.Y > 0.25f * along)
        {
            return false;
        }

        // As in SwingTwistLimit.TryBound, with all that is compared squared and times the length of (y, w).
        const float Squared = AnglePerHalfSine * AnglePerHalfSine;
        float x = (turn.X * turn.W) + (turn.Z * turn.Y);
        float z = (turn.Z * turn.W) - (turn.X * turn.Y);
        float twist = turn.Y * turn.W;
        float aa = x < 0f ? minX : maxX;
        float bb = z < 0f ? minZ : maxZ;
        float cc = twist < 0f ? minTwist : maxTwist;
        float swing = across > 0.25f ? WideAnglePerHalfSine * WideAnglePerHalfSine : Squared;
        return Squared * turn.Y * turn.Y <= cc * along && swing * ((x * x * bb) + (z * z * aa)) < aa * bb * along;
    }

    private static AngleRange Part(AngleRange range, float part) => new(range.Min * part, range.Max * part);
}
