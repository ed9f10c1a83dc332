using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Steps;

/// <summary>Where a leg is in its cycle, and how far a foot has come on its way: what the walk of grown creatures and <see cref="LegStepper"/> have in common.</summary>
internal static class StepPhase
{
    /// <summary>Part of the swing after which the target stays where it is.</summary>
    public const float Frozen = 0.85f;

    /// <summary>Part of the swing after which a foot that stayed down stays for this cycle.</summary>
    public const float LatestLift = 0.35f;

    /// <summary>A leg's place in its own cycle, 0..1: stance up to the duty, then swing.</summary>
    /// <param name="phase">Place of the body in the cycle.</param>
    /// <param name="lag">Of the leg's touchdown, parts of a cycle.</param>
    public static float Place(float phase, float lag)
    {
        float p = phase - lag;
        return p - (float)Math.Floor(p);
    }

    /// <summary>Progress of the swing, 0..1; below 0 in stance.</summary>
    public static float Swing(float place, float duty) => (place - duty) / (1f - duty);

    /// <summary>Seconds from a place in the swing to the middle of the stance to come: where the body will be then, the foot comes down under.</summary>
    /// <param name="flight">Seconds until it comes down.</param>
    /// <param name="duty">Part of the cycle that a foot is down.</param>
    /// <param name="cycle">Seconds of the cycle.</param>
    public static float ToMidstance(float flight, float duty, float cycle) => flight + (0.5f * duty * cycle);

    /// <summary>Share of its way over the ground that a swinging foot has gone: eased at both ends, and soonest on the way.</summary>
    /// <param name="swing">Progress of the swing, 0..1.</param>
    public static float Along(float swing) => Scalar.Smooth(swing * (0.93f + (0.07f * swing)));
}
