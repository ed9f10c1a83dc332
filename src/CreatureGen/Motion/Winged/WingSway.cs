using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>How far folded wings swing off the flank with a body that goes: they are left behind as it sinks and pressed down as it rises again, the one on the side that steps ahead opens the more, both as it starts and brakes, and the outer one in a turn.</summary>
internal struct WingSway
{
    /// <summary>Radians for each leg length that the body bounces, and for each leg length between the hind feet.</summary>
    private const float LiftPerBounce = 2.6f;
    private const float TiltPerStep = 0.09f;

    /// <summary>Radians for each part of gravity with which the body gets faster, with which it brakes, and for each radian at which its turn would be in balance.</summary>
    private const float LiftPerStart = 0.35f;
    private const float LiftPerBraking = 0.7f;
    private const float TiltPerBalance = 0.35f;

    /// <summary>Bounds of what is followed, radians: of steps, of starts and stops, and of turns.</summary>
    private const float MaxLift = 0.2f;
    private const float MaxTilt = 0.06f;
    private const float MaxOpened = 0.35f;
    private const float MaxTurned = 0.2f;

    /// <summary>How quickly a wing swings, 1/τ, τ = √(ℓ/g), and how soon that dies away.</summary>
    private const float Rate = 4.5f;
    private const float DampingRatio = 0.4f;

    /// <summary>Angle, radians, and speed, radians per second, below which nothing swings.</summary>
    private const float Stillness = 1e-4f;

    /// <summary>By how much a wing is eased off the flank it cannot go into, radians.</summary>
    private const float Softness = 0.03f;

    private float lift;
    private float liftRate;
    private float tilt;
    private float tiltRate;
    private float raised;

    /// <summary>How far the left wing is off the flank, radians.</summary>
    public readonly float Left => Off(lift + tilt) + raised;

    /// <summary>The same of the right one.</summary>
    public readonly float Right => Off(lift - tilt) + raised;

    /// <summary>Swings on.</summary>
    /// <param name="bounce">How high the body is above its mean height, leg lengths.</param>
    /// <param name="scissor">How far the left hind foot is ahead of the right one, leg lengths.</param>
    /// <param name="push">Acceleration ahead, parts of gravity.</param>
    /// <param name="balance">The angle to the left at which its turn would be in balance, radians.</param>
    /// <param name="raised">How far they are held off besides, radians.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(float bounce, float scissor, float push, float balance, float raised, float tau, float dt)
    {
        this.raised = raised;
        float opened = push > 0f ? LiftPerStart * push : -LiftPerBraking * push;
        float toLift = Scalar.ClampSoftly(LiftPerBounce * bounce, MaxLift) + Scalar.ClampSoftly(opened, MaxOpened);
        float toTilt = Scalar.ClampSoftly(TiltPerStep * scissor, MaxTilt) - Scalar.ClampSoftly(TiltPerBalance * balance, MaxTurned);
        if (IsStill(toLift) && IsStill(toTilt) && IsStill(lift) && IsStill(tilt) && IsStill(liftRate) && IsStill(tiltRate))
        {
            lift = liftRate = tilt = tiltRate = 0f;
            return;
        }

        var spring = new DampedSpring(Rate / tau, DampingRatio, dt);
        Swing(ref lift, ref liftRate, toLift, spring);
        Swing(ref tilt, ref tiltRate, toTilt, spring);
    }

    private static void Swing(ref float angle, ref float rate, float goal, in DampedSpring spring)
    {
        float off = angle - goal;
        angle = goal + (off * spring.PlaceOfPlace) + (rate * spring.PlaceOfVelocity);
        rate = (off * spring.VelocityOfPlace) + (rate * spring.VelocityOfVelocity);
    }

    private static bool IsStill(float value) => Math.Abs(value) < Stillness;

    /// <summary>An angle above 0, and hardly any below.</summary>
    private static float Off(float angle) => angle == 0f ? 0f : 0.5f * (angle + (float)Math.Sqrt((angle * angle) + (Softness * Softness)) - Softness);
}
