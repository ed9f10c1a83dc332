using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// The weight of a new motion while an old one fades out: 0 to 1 over a time, slow at both ends. A value to keep per creature; both motions go on playing and are mixed with
/// <see cref="PoseBlend"/>. Where the old motion cannot go on, use <see cref="Inertialisation"/>.
/// </summary>
public struct CrossFade
{
    private readonly float duration;
    private float elapsed;

    /// <summary>Starts at weight 0.</summary>
    /// <param name="seconds">How long it takes; 0 switches at once.</param>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative or not finite.</exception>
    public CrossFade(float seconds)
    {
        Finite.RequireStep(seconds);
        duration = seconds;
        elapsed = 0f;
    }

    /// <summary>Weight of the new motion, 0..1: x³(10 − 15x + 6x²) of the time passed.</summary>
    public readonly float Weight
    {
        get
        {
            if (elapsed >= duration)
            {
                return 1f;
            }

            float x = elapsed / duration;
            return x * x * x * (10f - (x * (15f - (6f * x))));
        }
    }

    /// <summary>Whether the old motion is gone. A fade that was never started is finished.</summary>
    public readonly bool IsFinished => elapsed >= duration;

    /// <summary>Lets time pass.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The time is negative or not finite.</exception>
    public void Advance(float seconds)
    {
        Finite.RequireStep(seconds);
        elapsed = Math.Min(elapsed + seconds, duration);
    }
}
