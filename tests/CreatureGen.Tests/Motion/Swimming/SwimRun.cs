using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;

namespace CreatureGen.Tests.Motion.Swimming;

/// <summary>Swimmers that swim for a time.</summary>
internal static class SwimRun
{
    /// <summary>Speeds up to three cruises, turns and climbs that change all the time, and a C-start now and then.</summary>
    public static SwimInput Wild(SwimProfile profile, double t) => new(
        (float)(profile.CruiseSpeed * 1.5 * (1 + PortableMath.Sin(1.7 * t))),
        (float)(6 * PortableMath.Sin(2.3 * t)),
        (float)(profile.CruiseSpeed * 2 * PortableMath.Sin(0.9 * t)),
        (int)t % 4 == 3 ? EscapeTurn.Right : EscapeTurn.None);

    /// <summary>Swims until all has settled, 60 updates to a beat at cruise.</summary>
    public static SwimState Steady(SwimProfile profile, SwimInput input, StrokeSubject body)
    {
        var state = default(SwimState);
        for (int i = 0; i < 800; i++)
        {
            SwimMotion.Update(profile, input, ref state, 1 / (60 * profile.CruiseFrequency), body.Local);
        }

        return state;
    }

    /// <summary>Goes through speeds, turns, climbs and a C-start and gives the largest change of a joint's angular velocity from one update to the next, rad/s.</summary>
    public static float Jerk(SwimProfile profile, Creature creature, int rate)
    {
        var body = new StrokeSubject(creature);
        var state = default(SwimState);
        float dt = 1 / (rate * profile.CruiseFrequency);
        for (int i = 0; i < 8 * rate; i++)
        {
            int part = i / rate;
            var input = new SwimInput((part % 3) * profile.CruiseSpeed, part % 2 == 0 ? 0.5f : -0.5f, part > 4 ? 0.4f : 0f, part == 6 ? EscapeTurn.Left : EscapeTurn.None);
            SwimMotion.Update(profile, input, ref state, dt, body.Local);
            body.Track(dt);
        }

        return body.Jerk;
    }

    /// <summary>Swims on for a time.</summary>
    public static void Go(SwimProfile profile, in SwimInput input, ref SwimState state, double seconds, int steps, StrokeSubject body)
    {
        for (int i = 0; i < steps; i++)
        {
            SwimMotion.Update(profile, input, ref state, (float)(seconds / steps), body.Local);
        }
    }
}
