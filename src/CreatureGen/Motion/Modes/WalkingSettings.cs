using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>What can be set on a creature's way of going on legs. Factors are 1 by default.</summary>
public sealed record WalkingSettings
{
    /// <summary>The defaults.</summary>
    public static WalkingSettings Default { get; } = new();

    /// <summary>
    /// How quickly the body follows as its creature speeds up or slows down, per second; 0.1..100. That of legs follows with a lag of 0.15 s at 4 s⁻¹, the default, on a leg of half a metre; it grows with the
    /// square root of the leg's length.
    /// </summary>
    public float SpeedResponse { get; init; } = 4f;

    /// <summary>The same of turning; 0.1..100.</summary>
    public float YawResponse { get; init; } = 4f;

    /// <summary>
    /// Grip of the feet on the ground, a factor; 0.05..3: 0.3 on ice, 1.5 with claws. It bounds speeding up (0.6 of gravity), braking (0.7) and the acceleration to a side in turns (0.6); pillar-legged
    /// creatures do half of that.
    /// </summary>
    public float Traction { get; init; } = 1f;

    /// <summary>
    /// How heavily it goes on its legs: as if it were so many times as large, a factor; 0.1..10. All takes √Heft times as long, and its speeds are so much lower, by dynamic similarity.
    /// </summary>
    public float Heft { get; init; } = 1f;

    /// <summary>Height of the swinging feet, a factor; 0..4.</summary>
    public float Lift { get; init; } = 1f;

    /// <summary>Length of the strides, a factor; 0.3..1.5. Shorter strides are quicker ones.</summary>
    public float Stride { get; init; } = 1f;

    /// <summary>Rise and fall of the body, a factor; 0..4.</summary>
    public float Bounce { get; init; } = 1f;

    /// <summary>Sway and roll of the body, a factor; 0..4.</summary>
    public float Sway { get; init; } = 1f;

    /// <summary>Lean into turns, a factor; 0..2.</summary>
    public float Bank { get; init; } = 1f;

    /// <summary>Bending of the back, a factor; 0..2.</summary>
    public float SpineMotion { get; init; } = 1f;

    /// <summary>How level the head is held, a factor; 0..1.3.</summary>
    public float HeadSteadiness { get; init; } = 1f;

    /// <summary>Motion of the tail, a factor; 0..4.</summary>
    public float TailMotion { get; init; } = 1f;

    /// <summary>A gait to keep to, whatever the speed; null to choose by speed.</summary>
    public Gait? Gait { get; init; }

    /// <summary>Passes good settings.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid()
    {
        Finite.RequireWithin(SpeedResponse, 0.1f, 100f, nameof(SpeedResponse));
        Finite.RequireWithin(YawResponse, 0.1f, 100f, nameof(YawResponse));
        Finite.RequireWithin(Traction, 0.05f, 3f, nameof(Traction));
        Finite.RequireWithin(Heft, 0.1f, 10f, nameof(Heft));
        Finite.RequireWithin(Lift, 0f, 4f, nameof(Lift));
        Finite.RequireWithin(Stride, 0.3f, 1.5f, nameof(Stride));
        Finite.RequireWithin(Bounce, 0f, 4f, nameof(Bounce));
        Finite.RequireWithin(Sway, 0f, 4f, nameof(Sway));
        Finite.RequireWithin(Bank, 0f, 2f, nameof(Bank));
        Finite.RequireWithin(SpineMotion, 0f, 2f, nameof(SpineMotion));
        Finite.RequireWithin(HeadSteadiness, 0f, 1.3f, nameof(HeadSteadiness));
        Finite.RequireWithin(TailMotion, 0f, 4f, nameof(TailMotion));
        Gait?.ThrowIfInvalid();
    }
}
