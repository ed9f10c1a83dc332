using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Clips;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion;

/// <summary>Turns the motion of an animator into clips: one exact, closed cycle of each thing that a creature does, in place, on level ground.</summary>
/// <remarks>
/// The animator runs until its motion repeats; then one cycle is taken in a whole number of frames, and played at its rate it lasts up to half a frame more or less than the live
/// one. The rate is <see cref="Clip.UsualRate"/>, doubled until no joint turns far from frame to frame: quick wings would strobe. What is left between the last and the first frame is spread evenly over the cycle, so that the loop closes to the bit.
/// </remarks>
public static class ClipBaker
{
    private const int FewestFrames = 8;

    /// <summary>Metres of air below what sinks as it goes.</summary>
    private const float Depth = 1000f;

    private static readonly string[] ways =
    {
        "Idle", "Walk", "DiagonalWalk", "Amble", "Crawl", "Trot", "SprawlTrot", "Pace", "Canter", "TransverseGallop", "RotaryGallop", "Bound", "Pronk", "Run", "Hop", "Leap", "Wave", "Tripod", "Tetrapod",
        "SlowWave", "BackwardWave", "Fly", "Hover", "Glide", "TakeOff", "Land", "Swim", "CStart", "Slither", "Sidewind", "Rectilinear",
        "TurnLeft", "TurnRight", "BankLeft", "BankRight", "StrafeLeft", "StrafeRight", "Reverse", "LookAround", "Start", "Stop", "Jump", "Fall", "Dart",
    };

    /// <summary>Every name that a clip of a creature with the library's own gaits and acts can have.</summary>
    public static IReadOnlyList<string> Names { get; } = ways.Concat(ActLibrary.All.Select(act => act.Name)).Distinct(StringComparer.Ordinal).ToArray();

    /// <summary>Bakes all that a creature does by itself: idling, each of its gaits, flight, swimming, crawling, and what leads from one to another by itself. All that can be baked is in <see cref="RecipesOf"/>.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static IReadOnlyList<Clip> Bake(Creature creature)
    {
        var profile = new MotionProfile(creature ?? throw new ArgumentNullException(nameof(creature)));
        var clips = new List<Clip>();
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            clips.Add(Bake(profile, movement));
        }

        return clips;
    }

    /// <summary>Everything that can be baked of a creature, each clip by its name: what <see cref="Bake(Creature)"/> bakes, turning, going aside and back, looking around, banking, gliding, starting, stopping, jumping, falling, landing, darting, and every act that it can do.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<ClipRecipe> RecipesOf(MotionProfile profile)
    {
        _ = profile ?? throw new ArgumentNullException(nameof(profile));
        var recipes = new List<ClipRecipe>();
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            recipes.Add(new ClipRecipe(movement.Name, () => Bake(profile, movement)));
        }

        foreach (Movement movement in Movement.Manoeuvres(profile))
        {
            recipes.Add(new ClipRecipe(movement.Name, () => Bake(profile, movement)));
        }

        recipes.AddRange(Passages.Of(profile));
        foreach (ActAbility ability in profile.Acts.Possible)
        {
            recipes.Add(new ClipRecipe(ability.Act.Name, () => RecordedAct.Bake(profile, ability)));
        }

        return recipes;
    }

    /// <summary>Bakes every act that a creature can do, each from standing to standing on the spot; what lasts is there for its least time. The name is that of the act.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static IReadOnlyList<Clip> BakeActs(Creature creature)
    {
        var profile = new MotionProfile(creature ?? throw new ArgumentNullException(nameof(creature)));
        var clips = new List<Clip>();
        foreach (ActAbility ability in profile.Acts.Possible)
        {
            clips.Add(RecordedAct.Bake(profile, ability));
        }

        return clips;
    }

    /// <summary>Bakes one thing that a creature does. What it may be is in <see cref="Movement.Of"/>, and without the acts, which take a while to find out, in <see cref="Movement.OfGoing"/>.</summary>
    /// <param name="profile">Of the creature.</param>
    /// <param name="movement">One of its own.</param>
    /// <exception cref="ArgumentNullException">There is no profile or no movement.</exception>
    /// <exception cref="ArgumentException">The creature does not do that; the message lists its ways of going.</exception>
    public static Clip Bake(MotionProfile profile, Movement movement)
    {
        _ = profile ?? throw new ArgumentNullException(nameof(profile));
        _ = movement ?? throw new ArgumentNullException(nameof(movement));
        if (!movement.IsOf(profile))
        {
            string own = string.Join(", ", Movement.OfGoing(profile).Select(one => one.Name));
            throw new ArgumentException(FormattableString.Invariant($"the creature does not do \"{movement.GaitName}\"; it goes by {own}, and acts as its acts list"), nameof(movement));
        }

        if (movement.Act is { } ability)
        {
            return RecordedAct.Bake(profile, ability);
        }

        SteadyMotion motion = Begin(profile, movement);
        float seconds = motion.CycleSeconds();
        int rate = Clip.UsualRate;
        RecordedCycle cycle = Record(motion, seconds, rate);
        while (ClipRate.IsTooLow(rate, cycle.FarthestTurn()))
        {
            rate *= 2;
            motion = motion.Closes ? motion : Begin(profile, movement);
            cycle = Record(motion, seconds, rate);
        }

        if (!motion.Closes)
        {
            Carry(profile, cycle);
        }

        var clip = new Clip(movement.Name, motion.Closes ? ClipEnd.Loops : ClipEnd.Stays, rate, (float)(cycle.MeanSpeed * cycle.Step * rate), cycle.Joints, cycle.Rotations, cycle.Positions);
        return clip.WithEvents(cycle.EventsAt(rate)).WithPath(movement.Input == default ? Array.Empty<ClipPlace>() : cycle.Path());
    }

    private static SteadyMotion Begin(MotionProfile profile, Movement movement)
    {
        bool sinks = movement.Kind == ClipKind.Lasting && movement.Input.ClimbRate < 0f;
        var motion = new SteadyMotion(profile, movement, sinks ? new FlatGround(new Vector3(0f, -Depth, 0f), Vector3.UnitY) : FlatGround.Level);
        motion.Settle(SteadyMotion.SettleSeconds);
        return motion;
    }

    /// <summary>Puts height and heading of the root into the body's joint: in place is what stays over its point of the ground.</summary>
    private static void Carry(MotionProfile profile, RecordedCycle cycle)
    {
        int body = profile.Subject.Skeleton.FirstOf(Rigging.JointRole.Body);
        for (int frame = 0; frame <= cycle.Frames; frame++)
        {
            int at = (frame * cycle.Joints) + body;
            Quaternion heading = cycle.PlaceAt(frame).Rotation;
            cycle.Positions[at] = Rotation.Rotate(heading, cycle.Positions[at]) + new Vector3(0f, cycle.PlaceAt(frame).Position.Y, 0f);
            cycle.Rotations[at] = Rotation.Multiply(heading, cycle.Rotations[at]);
        }
    }

    private static RecordedCycle Record(SteadyMotion motion, float seconds, int rate)
    {
        int frames = Math.Max(FewestFrames, (int)Math.Round(seconds * rate));
        float step = seconds / frames;
        for (int k = 0; k < 2 * frames && motion.Closes; k++)
        {
            motion.Advance(step);
        }

        return new RecordedCycle(motion, frames, step);
    }
}
