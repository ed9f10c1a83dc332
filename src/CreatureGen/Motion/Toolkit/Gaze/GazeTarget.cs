using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;

namespace CreatureGen.Motion.Toolkit;

/// <summary>What a creature looks at.</summary>
public readonly struct GazeTarget
{
    private GazeTarget(GazeTargetKind kind, Vector3 point, LookAngles angles)
    {
        Kind = kind;
        Point = point;
        Angles = angles;
    }

    /// <summary>Nothing: the head fades back into its motion.</summary>
    public static GazeTarget None => default;

    internal GazeTargetKind Kind { get; }

    internal Vector3 Point { get; }

    internal LookAngles Angles { get; }

    /// <summary>A point.</summary>
    /// <param name="point">Model space, metres.</param>
    /// <exception cref="System.ArgumentException">The point is not finite.</exception>
    public static GazeTarget At(Vector3 point)
    {
        Finite.Require(point, nameof(point));
        return new GazeTarget(GazeTargetKind.Point, point, default);
    }

    /// <summary>A direction relative to the trunk that carries the neck.</summary>
    /// <param name="angles">Round to the left and up.</param>
    /// <exception cref="System.ArgumentException">An angle is not finite.</exception>
    public static GazeTarget Towards(LookAngles angles)
    {
        Finite.Require(angles.Yaw, nameof(angles));
        Finite.Require(angles.Pitch, nameof(angles));
        return new GazeTarget(GazeTargetKind.Direction, default, angles);
    }
}
