using System;
using System.Collections.Generic;
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
    private const int HighestRate = 240;

    /// <summary>Most that a joint may turn from frame to frame, radians; about twelve frames make a beat of a wing.</summary>
    private const float FarthestTurn = 0.5f;

    /// <summary>Bakes every clip of a creature.</summary>
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

    private static Clip Bake(MotionProfile profile, Movement movement)
    {
        SteadyMotion motion = Begin(profile, movement);
        float seconds = motion.CycleSeconds();
        int rate = Clip.UsualRate;
        RecordedCycle cycle = Record(motion, seconds, rate);
        while (cycle.FarthestTurn() > FarthestTurn && rate < HighestRate)
        {
            rate *= 2;
            motion = motion.Closes ? motion : Begin(profile, movement);
            cycle = Record(motion, seconds, rate);
        }

        if (!motion.Closes)
        {
            Carry(profile, cycle);
        }

        return new Clip(movement.Name, motion.Closes ? ClipEnd.Loops : ClipEnd.Stays, rate, (float)(cycle.MeanSpeed * cycle.Step * rate), cycle.Joints, cycle.Rotations, cycle.Positions).WithEvents(cycle.EventsAt(rate));
    }

    private static SteadyMotion Begin(MotionProfile profile, Movement movement)
    {
        var motion = new SteadyMotion(profile, movement, FlatGround.Level);
        motion.Settle(SteadyMotion.SettleSeconds);
        return motion;
    }

    /// <summary>Puts height and heading of the root into the body's joint: in place is what stays over its point of the ground.</summary>
    private static void Carry(MotionProfile profile, RecordedCycle cycle)
    {
        int body = profile.Creature.Skeleton.IndexOf("Body");
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
