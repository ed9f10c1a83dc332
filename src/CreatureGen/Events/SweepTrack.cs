using System;
using CreatureGen.Maths;

namespace CreatureGen.Events;

/// <summary>What is remembered of a limb that sweeps, while it goes on.</summary>
internal struct SweepTrack
{
    /// <summary>Part of the usual length of a sweep that it has to last before it is one: a leg that straightens in its swing flicks back for a moment.</summary>
    private const float Settled = 0.15f;

    private bool started;
    private bool returned;
    private float along;
    private float speed;
    private float fastestBack;
    private float usual;
    private float swept;
    private float sweeping;
    private float usualLength;
    private bool begun;
    private float lasted;
    private float strengthThen;

    /// <summary>Takes the next update; whether a sweep that has begun has lasted long enough in it.</summary>
    /// <param name="now">Where the line ends, as far as that is towards, lengths.</param>
    /// <param name="dt">Seconds since the last, above 0.</param>
    /// <param name="rule">With a sweep.</param>
    /// <param name="strength">Its speed as it began, in thresholds.</param>
    /// <param name="ago">Seconds from its beginning to the end of the update.</param>
    public bool Passes(float now, float dt, AngularRule rule, out float strength, out float ago)
    {
        strength = ago = 0f;
        float before = speed;
        speed = started ? (now - along) / dt : 0f;
        along = now;
        started = true;
        AngularSweep sweep = rule.Sweep!;
        float min = (float)rule.Threshold;
        fastestBack = Math.Min(fastestBack * Damping.Left(0.6931472f / AngularEventStream.Memory, dt), speed);
        if (speed <= sweep.ReturnsAt * Math.Min(fastestBack, -min))
        {
            Learn();
            returned = true;
        }

        float begins = Math.Max(min, sweep.BeginsAt * usual);
        if (speed > min)
        {
            swept += speed * dt;
            sweeping += dt;
        }

        if (!returned || speed < begins || usual == 0f)
        {
            begun = false;
            return false;
        }

        if (begun)
        {
            lasted += dt;
        }
        else
        {
            // A speed is that of the middle of its update.
            begun = true;
            lasted = dt * (0.5f + (before < begins ? (speed - begins) / (speed - before) : 0f));
            strengthThen = begins > 0f ? speed / begins : 1f;
        }

        if (lasted < Settled * usualLength)
        {
            return false;
        }

        returned = begun = false;
        strength = strengthThen;
        ago = lasted;
        return true;
    }

    /// <summary>A stroke is over: its mean speed and its length count for half of what is usual, unless it was none.</summary>
    private void Learn()
    {
        if (sweeping > Settled * usualLength)
        {
            float mean = swept / sweeping;
            usual = usual > 0f ? 0.5f * (usual + mean) : mean;
            usualLength = usualLength > 0f ? 0.5f * (usualLength + sweeping) : sweeping;
        }

        swept = sweeping = 0f;
    }
}
