using System;
using CreatureGen.Maths;

namespace CreatureGen.Events;

/// <summary>What is remembered of a limb that sweeps, while it goes on.</summary>
internal struct SweepTrack
{
    private bool started;
    private bool returned;
    private float along;
    private float speed;
    private float fastestBack;
    private float usual;
    private float swept;
    private float sweeping;

    /// <summary>Takes the next update; whether a sweep has begun in it.</summary>
    /// <param name="now">Where the line ends, as far as that is towards, lengths.</param>
    /// <param name="dt">Seconds since the last, above 0.</param>
    /// <param name="rule">With a sweep.</param>
    /// <param name="strength">Its speed, in thresholds.</param>
    /// <param name="ago">Seconds before the end of the update.</param>
    public bool Passes(float now, float dt, AngularRule rule, out float strength, out float ago)
    {
        strength = ago = 0f;
        float before = speed;
        speed = started ? (now - along) / dt : 0f;
        along = now;
        started = true;
        AngularSweep sweep = rule.Sweep!;
        float least = (float)rule.Threshold;
        fastestBack = Math.Min(fastestBack * Damping.Left(0.6931472f / AngularEventStream.Memory, dt), speed);
        if (speed <= sweep.ReturnsAt * Math.Min(fastestBack, -least))
        {
            Learn();
            returned = true;
        }

        float begins = Math.Max(least, sweep.BeginsAt * usual);
        if (speed > least)
        {
            swept += speed * dt;
            sweeping += dt;
        }

        if (!returned || speed < begins || usual == 0f)
        {
            return false;
        }

        returned = false;

        // A speed is that of the middle of its update.
        ago = dt * (0.5f + (before < begins ? (speed - begins) / (speed - before) : 0f));
        strength = begins > 0f ? speed / begins : 1f;
        return true;
    }

    /// <summary>A stroke is over: its mean speed counts for half of what is usual.</summary>
    private void Learn()
    {
        if (sweeping > 0f)
        {
            float mean = swept / sweeping;
            usual = usual > 0f ? 0.5f * (usual + mean) : mean;
            swept = sweeping = 0f;
        }
    }
}
