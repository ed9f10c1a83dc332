using System;

namespace CreatureGen.Motion.Falling;

/// <summary>How deep and how long a body crouches for a jump, how long it flies.</summary>
/// <param name="LegLength">World metres.</param>
/// <param name="CrouchDepth">Deepest crouch, world metres.</param>
/// <param name="Gravity">World m/s².</param>
internal readonly record struct LeapTiming(float LegLength, float CrouchDepth, float Gravity)
{
    /// <summary>Seconds of the crouch, τ = √(ℓ/g); its depth, and how far legs are stretched at the end, parts of the deepest crouch.</summary>
    private const float CrouchTime = 1.6f;
    private const float Depth = 0.8f;
    private const float Stretched = 0.08f;

    /// <summary>Least height of a jump, leg lengths.</summary>
    private const float MinHeight = 0.12f;

    /// <summary>How far the body is let down in a part of a whole crouch, world metres.</summary>
    public float DepthOf(float crouch) => crouch * Depth * CrouchDepth;

    /// <summary>From there to where its feet leave the ground, world metres.</summary>
    public float PushOf(float crouch) => DepthOf(crouch) + (Stretched * CrouchDepth);

    /// <summary>Time that a part of a whole crouch takes.</summary>
    public float CrouchSeconds(float crouch) => crouch * CrouchTime * (float)Math.Sqrt(LegLength / Gravity);

    /// <summary>Time of the push out of it that ends at a speed upwards.</summary>
    public float PushSeconds(float crouch, float upward) => 2f * PushOf(crouch) / upward;

    /// <summary>Time from the order until its feet leave the ground.</summary>
    public float WindUpSeconds(float crouch, float upward) => CrouchSeconds(crouch) + PushSeconds(crouch, upward);

    /// <summary>Time from the take-off until it is at a height above it, on the way down.</summary>
    public float FlightSeconds(float upward, float height) => (upward + (float)Math.Sqrt(Math.Max((upward * upward) - (2f * Gravity * height), 0f))) / Gravity;

    /// <summary>Least speed upwards of a jump to a height.</summary>
    public float Lowest(float height) => (float)Math.Sqrt(2f * Gravity * (Math.Max(height, 0f) + (MinHeight * LegLength)));
}
