using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>
/// What can be set on a creature's motion, at any time, without a restart: what all ways of moving share, and one record for each of them. SI units; factors are 1 by default. Copy <see cref="Default"/> and change it; the records are immutable and are changed by <c>with</c>.
/// </summary>
public struct MotionSettings
{
    /// <summary>The defaults.</summary>
    public static MotionSettings Default => new()
    {
        Up = Vector3.UnitY,
        Gravity = StandardGravity.Acceleration,
        Idle = 1f,
        IdleActs = 0f,
        Walking = WalkingSettings.Default,
        Flying = FlyingSettings.Default,
        Swimming = SwimmingSettings.Default,
        Slithering = SlitheringSettings.Default,
    };

    /// <summary>Unit direction away from the ground, world space. It may change at any time: on a small planet, or on a wall.</summary>
    public Vector3 Up { get; set; }

    /// <summary>Metres per second squared; 0.1..1000. It decides which gait suits a speed, how far bodies lean into turns, and how hard landings are.</summary>
    public float Gravity { get; set; }

    /// <summary>Breathing, shifting of weight, looking about and flicking ears while it stands, a factor; 0..4. Blinks stay.</summary>
    public float Idle { get; set; }

    /// <summary>How often a creature that stands about begins an act by itself, from its seed: it sniffs, shakes, scratches, grooms itself, calls, sits for a while. 0..4, 0 never, 1 every quarter of a minute or so, bigger ones less often. To set it
    /// above 0 for the first time takes what <see cref="MotionProfile.Acts"/> takes.</summary>
    public float IdleActs { get; set; }

    /// <summary>How much of it is worked out: less for creatures far from the camera. It may change at any time; poses do not jump. To set <see cref="MotionDetail.Far"/> for the first time of a profile takes some ten milliseconds.</summary>
    public MotionDetail Detail { get; set; }

    /// <summary>On legs.</summary>
    public WalkingSettings Walking { get; set; }

    /// <summary>On wings.</summary>
    public FlyingSettings Flying { get; set; }

    /// <summary>In water.</summary>
    public SwimmingSettings Swimming { get; set; }

    /// <summary>On the belly.</summary>
    public SlitheringSettings Slithering { get; set; }

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range, or a record is missing; the message says which.</exception>
    public readonly void ThrowIfInvalid()
    {
        Finite.Require(Up, nameof(Up));
        if (!(Math.Abs(Vec.LengthSquared(Up) - 1f) < 1e-3f))
        {
            throw new ArgumentOutOfRangeException(nameof(Up), FormattableString.Invariant($"({Up.X}, {Up.Y}, {Up.Z})"), "expected a unit vector");
        }

        Finite.RequireWithin(Gravity, 0.1f, 1000f, nameof(Gravity));
        Finite.RequireWithin(Idle, 0f, 4f, nameof(Idle));
        Finite.RequireWithin(IdleActs, 0f, 4f, nameof(IdleActs));
        if (Detail is not (MotionDetail.Full or MotionDetail.Far))
        {
            throw new ArgumentOutOfRangeException(nameof(Detail), Detail, "expected Full or Far");
        }

        (Walking ?? throw new ArgumentNullException(nameof(Walking))).ThrowIfInvalid();
        (Flying ?? throw new ArgumentNullException(nameof(Flying))).ThrowIfInvalid();
        (Swimming ?? throw new ArgumentNullException(nameof(Swimming))).ThrowIfInvalid();
        (Slithering ?? throw new ArgumentNullException(nameof(Slithering))).ThrowIfInvalid();
    }
}
