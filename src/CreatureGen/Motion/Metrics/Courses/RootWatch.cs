using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Watches where a root is: how its velocity changes between spells of at least a sixtieth of a second.</summary>
internal sealed class RootWatch
{
    private const float Spell = 1f / 60f;
    private const float Slack = 1e-5f;

    private Vector3 from;
    private float seconds;
    private Vector3 velocity;
    private float velocitySeconds;

    /// <summary>Watches from a place on, at rest.</summary>
    public RootWatch(Vector3 place)
    {
        from = place;
        velocitySeconds = Spell;
    }

    /// <summary>Metres per second squared.</summary>
    public float Acceleration { get; private set; }

    /// <summary>Watches a place.</summary>
    /// <param name="place">World space.</param>
    /// <param name="dt">Seconds since the last.</param>
    public void Record(Vector3 place, float dt)
    {
        seconds += dt;
        if (seconds < Spell - Slack)
        {
            return;
        }

        Vector3 now = (place - from) / seconds;
        Acceleration = Math.Max(Acceleration, Vec.Length(now - velocity) / (0.5f * (seconds + velocitySeconds)));
        from = place;
        velocity = now;
        velocitySeconds = seconds;
        seconds = 0f;
    }
}
