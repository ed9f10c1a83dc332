using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on a creature's way of going, at any time, without a restart. SI units; factors are 1 by default. Copy <see cref="Default"/> and change it.</summary>
public struct LocomotionSettings
{
    /// <summary>The defaults.</summary>
    public static LocomotionSettings Default => new()
    {
        Up = Vector3.UnitY,
        Gravity = 9.81f,
        SpeedResponse = 4f,
        YawResponse = 4f,
        Traction = 1f,
        Lift = 1f,
        Bounce = 1f,
        Sway = 1f,
        SpineMotion = 1f,
        HeadSteadiness = 1f,
        TailMotion = 1f,
        Idle = 1f,
        Bank = 1f,
        Stride = 1f,
    };

    /// <summary>Unit direction away from the ground, world space. It may change at any time: on a small planet, or on a wall.</summary>
    public Vector3 Up { get; set; }

    /// <summary>Metres per second squared; 0.1..1000.</summary>
    public float Gravity { get; set; }

    /// <summary>
    /// How quickly the body follows as its creature speeds up or slows down, per second; 0.1..100. That of legs follows with a lag of 0.15 s at 4 s⁻¹, the default, on a leg of half a metre; it grows with the
    /// square root of the leg's length.
    /// </summary>
    public float SpeedResponse { get; set; }

    /// <summary>The same of turning; 0.1..100.</summary>
    public float YawResponse { get; set; }

    /// <summary>
    /// Grip of the feet on the ground, a factor; 0.05..3: 0.3 on ice, 1.5 with claws. It bounds speeding up (0.6 of gravity), braking (0.7) and the acceleration to a side in turns (0.6); pillar-legged
    /// creatures do half of that.
    /// </summary>
    public float Traction { get; set; }

    /// <summary>Height of the swinging feet, a factor; 0..4.</summary>
    public float Lift { get; set; }

    /// <summary>Rise and fall of the body, a factor; 0..4.</summary>
    public float Bounce { get; set; }

    /// <summary>Sway and roll of the body, a factor; 0..4.</summary>
    public float Sway { get; set; }

    /// <summary>Bending of the back, a factor; 0..2.</summary>
    public float SpineMotion { get; set; }

    /// <summary>How level the head is held, a factor; 0..1.3.</summary>
    public float HeadSteadiness { get; set; }

    /// <summary>Motion of the tail, a factor; 0..4.</summary>
    public float TailMotion { get; set; }

    /// <summary>Breathing, shifting of weight and looking about while it stands, a factor; 0..4.</summary>
    public float Idle { get; set; }

    /// <summary>Lean into turns, a factor; 0..2.</summary>
    public float Bank { get; set; }

    /// <summary>Length of the strides, a factor; 0.3..1.5. Shorter strides are quicker ones.</summary>
    public float Stride { get; set; }

    /// <summary>A gait to keep to, whatever the speed; null to choose by speed.</summary>
    public Gait? Gait { get; set; }

    /// <summary>How a creature without legs crawls. A change passes down its body as it moves on.</summary>
    public SlitherGait Crawl { get; set; }

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public readonly void ThrowIfInvalid()
    {
        Finite.Require(Up, nameof(Up));
        if (!(Math.Abs(Vec.LengthSquared(Up) - 1f) < 1e-3f))
        {
            throw new ArgumentOutOfRangeException(nameof(Up), FormattableString.Invariant($"({Up.X}, {Up.Y}, {Up.Z})"), "expected a unit vector");
        }

        Finite.RequireWithin(Gravity, 0.1f, 1000f, nameof(Gravity));
        Finite.RequireWithin(SpeedResponse, 0.1f, 100f, nameof(SpeedResponse));
        Finite.RequireWithin(YawResponse, 0.1f, 100f, nameof(YawResponse));
        Finite.RequireWithin(Traction, 0.05f, 3f, nameof(Traction));
        Finite.RequireWithin(Lift, 0f, 4f, nameof(Lift));
        Finite.RequireWithin(Bounce, 0f, 4f, nameof(Bounce));
        Finite.RequireWithin(Sway, 0f, 4f, nameof(Sway));
        Finite.RequireWithin(SpineMotion, 0f, 2f, nameof(SpineMotion));
        Finite.RequireWithin(HeadSteadiness, 0f, 1.3f, nameof(HeadSteadiness));
        Finite.RequireWithin(TailMotion, 0f, 4f, nameof(TailMotion));
        Finite.RequireWithin(Idle, 0f, 4f, nameof(Idle));
        Finite.RequireWithin(Bank, 0f, 2f, nameof(Bank));
        Finite.RequireWithin(Stride, 0.3f, 1.5f, nameof(Stride));
        Gait?.ThrowIfInvalid();
        if (Crawl is < SlitherGait.Undulating or > SlitherGait.Rectilinear)
        {
            throw new ArgumentOutOfRangeException(nameof(Crawl), Crawl, "expected Undulating, Sidewinding or Rectilinear");
        }
    }
}
