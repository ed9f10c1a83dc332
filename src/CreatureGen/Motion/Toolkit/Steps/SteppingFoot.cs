using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where a foot of a <see cref="LegStepper"/> is, and where it steps. A value, kept by the caller; world space, metres.</summary>
public struct SteppingFoot
{
    /// <summary>A foot that rests at a place.</summary>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public SteppingFoot(Vector3 position)
    {
        Finite.Require(position, nameof(position));
        Position = From = To = position;
        Normal = Vector3.UnitY;
        Progress = 1f;
    }

    /// <summary>Where it is: the target of its leg.</summary>
    public Vector3 Position { get; internal set; }

    /// <summary>Where it lifted off.</summary>
    public Vector3 From { get; internal set; }

    /// <summary>Where it comes down, or has come down.</summary>
    public Vector3 To { get; internal set; }

    /// <summary>Of the ground there, unit.</summary>
    public Vector3 Normal { get; internal set; }

    /// <summary>Part of the step that is over, 0 to 1; 1 at rest.</summary>
    public float Progress { get; internal set; }

    /// <summary>Place in its gait's swing at which it left the ground.</summary>
    internal float LiftAt;

    /// <summary>Whether it is in the air.</summary>
    public readonly bool IsStepping => Progress < 1f;
}
