using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics;

/// <summary>Scripts as restless players give them, drawn from a creature's seed.</summary>
/// <remarks>Commands last whole sixths of a second, so that those of 30, 60, 144 and 480 Hz begin with the same update.</remarks>
public static class CourseScripts
{
    /// <summary>Seconds at the end of random scripts for which the creature is asked to stand.</summary>
    public const float RestSeconds = 3f;

    private const int SixthsAtMin = 2;
    private const int SixthsAtMax = 17;

    /// <summary>What creatures without gaits are asked for at most, in cruising speeds.</summary>
    private const float CruisesAtMax = 1.5f;

    /// <summary>Speeds of climbing and sinking at most, in speeds ahead.</summary>
    private const float ClimbFraction = 0.3f;

    private const float SpinRate = 1.5f;
    private const double AirChance = 0.75;

    /// <summary>Radians per second of a key that turns.</summary>
    private const float KeyTurn = 2.5f;

    // Of the top speed.
    private static readonly float[] keySpeeds = { 0f, 0.5f, 0.5f, 1f, 1f, -0.25f };

    /// <summary>Random speeds from standing to the creature's top speed and random turns to both sides, then rest. Fliers do so on the ground and in the air, swimmers and fliers climb and sink.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="seconds">Of the random part, 1..600.</param>
    /// <param name="fastestTurn">Radians per second at most, 0..20; 0 for straight ahead.</param>
    /// <exception cref="ArgumentException">A number is not within its range.</exception>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static CourseScript Random(MotionProfile profile, float seconds, float fastestTurn)
    {
        Finite.RequireWithin(fastestTurn, 0f, 20f, nameof(fastestTurn));
        return Drawn(profile, fastestTurn > 0f ? "random" : "straight", seconds, (random, medium) =>
        {
            MotionInput ahead = Ahead(profile, random, medium, 0f);
            return new CourseCommand(1f, ahead with { YawRate = (float)random.Uniform(-fastestTurn, fastestTurn) });
        });
    }

    /// <summary>Everything a player can ask for: speeds, turns, backing up, strafing, standing, and gaits at speeds that are not theirs; then rest.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="seconds">Of the random part, 1..600.</param>
    /// <exception cref="ArgumentException">The time is not within its range.</exception>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static CourseScript Mixed(MotionProfile profile, float seconds) => Drawn(profile, "mixed", seconds, (random, medium) =>
    {
        MotionInput ahead = Ahead(profile, random, medium, 0f);
        float turn = (float)random.Uniform(-2, 2);
        float aside = (float)random.Uniform(-0.3, 0.3) * ahead.Speed;
        Gait? gait = profile.Gaits is GaitSet gaits ? gaits.Speeds[random.Integer(0, gaits.Speeds.Count)].Gait : null;
        return random.Integer(0, 8) switch
        {
            0 => new CourseCommand(1f, ahead with { Speed = 0f, YawRate = turn }),
            1 => new CourseCommand(1f, ahead with { Speed = -0.25f * ahead.Speed, YawRate = 0.5f * turn }),
            2 => new CourseCommand(1f, ahead with { Speed = 0f, Sideways = aside }),
            3 => new CourseCommand(1f, ahead with { Speed = 0.5f * ahead.Speed, Sideways = aside, YawRate = 0.5f * turn }),
            4 => new CourseCommand(1f, ahead, gait),
            5 => new CourseCommand(1f, ahead),
            _ => new CourseCommand(1f, ahead with { YawRate = turn }),
        };
    });

    /// <summary>Random speeds from half the top speed to all of it, straight ahead, then rest. Fliers do so on their feet.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="seconds">Of the random part, 1..600.</param>
    /// <exception cref="ArgumentException">The time is not within its range.</exception>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static CourseScript Runner(MotionProfile profile, float seconds) =>
        Drawn(profile, "runner", seconds, (random, _) => new CourseCommand(1f, Ahead(profile, random, MotionMedium.Ground, 0.5f)));

    /// <summary>Keys that are held and let go, as who plays without a stick gives them: standing, half the top speed, all of it or backing up, each with a hard turn to the left, to the right or none, from one update to the next; then rest. Fliers do so on their feet.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="seconds">Of the random part, 1..600.</param>
    /// <exception cref="ArgumentException">The time is not within its range.</exception>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static CourseScript Keys(MotionProfile profile, float seconds) => Drawn(profile, "keys", seconds, (random, _) =>
    {
        float speed = Top(profile, MotionMedium.Ground) * keySpeeds[random.Integer(0, keySpeeds.Length)];
        return new CourseCommand(1f, new MotionInput(speed, KeyTurn * (random.Integer(0, 3) - 1)));
    });

    /// <summary>Turns on the spot to one side and to the other; fliers in the air afterwards too.</summary>
    /// <param name="profile">The creature's.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static CourseScript Spin(MotionProfile profile)
    {
        Require(profile);
        var commands = new List<CourseCommand>();
        foreach (MotionMedium medium in profile.Flight == null ? new[] { MotionMedium.Ground } : new[] { MotionMedium.Ground, MotionMedium.Air })
        {
            foreach (float turn in new[] { 0f, SpinRate, 0f, -SpinRate, 0f })
            {
                commands.Add(new CourseCommand(turn == 0f ? 1f : 4f, new MotionInput(0f, turn, Medium: medium)));
            }
        }

        return new CourseScript("spin", commands);
    }

    private static CourseScript Drawn(MotionProfile profile, string name, float seconds, Func<RandomStream, MotionMedium, CourseCommand> draw)
    {
        Require(profile);
        Finite.RequireWithin(seconds, 1f, 600f, nameof(seconds));
        RandomStream random = new Seed(profile.Subject.Seed).Child("courses").Child(name).Stream();
        var commands = new List<CourseCommand>();
        int sixths = (int)Math.Ceiling(6f * seconds);
        while (sixths > 0)
        {
            int time = Math.Min(random.Integer(SixthsAtMin, SixthsAtMax + 1), sixths);
            bool airborne = random.Chance(AirChance) && profile.Flight != null;
            commands.Add(draw(random, airborne ? MotionMedium.Air : MotionMedium.Ground) with { Seconds = time / 6f });
            sixths -= time;
        }

        commands.Add(new CourseCommand(RestSeconds, default));
        return new CourseScript(name, commands);
    }

    private static void Require(MotionProfile profile)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }
    }

    private static MotionInput Ahead(MotionProfile profile, RandomStream random, MotionMedium medium, float min)
    {
        float speed = Top(profile, medium) * (float)random.Uniform(min, 1);
        float climb = ClimbFraction * speed * (float)random.Uniform(-1, 1);
        bool climbs = profile.Swim != null || medium == MotionMedium.Air;
        return new MotionInput(speed, ClimbRate: climbs ? climb : 0f, Medium: medium);
    }

    private static float Top(MotionProfile profile, MotionMedium medium) =>
        profile.Gaits != null && medium == MotionMedium.Ground ? profile.Gaits.TopSpeed : CruisesAtMax * Cruise(profile);

    private static float Cruise(MotionProfile profile) => profile.Flight?.CruiseSpeed ?? profile.Swim?.CruiseSpeed ?? profile.Slither?.CruiseSpeed ?? 0f;
}
