using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Clips;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;
using CreatureGen.Seeding;

namespace CreatureGen.Preview.Films;

/// <summary>
/// A creature in motion as a camera sees it that goes along at its mean speed: so many whole cycles as it takes until everything, the ground too, is as it was. Moments are counted from 0; the one
/// after the last is the first again.
/// </summary>
/// <remarks>The ground repeats itself too: where one cycle is shorter than a hill, or than two of the checks on it, several are taken.</remarks>
internal sealed class Take
{
    /// <summary>Pictures of a film strip: the frames of what repeats are a multiple of it.</summary>
    public const int StripFrames = 8;

    private const float FrameRate = 30f;
    private const int MaxFrames = 120;

    // Moments of a stroke at least, for the diagram.
    private const int MinMoments = 240;

    // Hills are not shorter than this, leg lengths.
    private const float ShortestPeriod = 4f;

    // Way of the whole film at least, body lengths, for checks that can be seen: many-legged creatures take small steps.
    private const float ShortestWay = 0.16f;
    private const float MaxCycles = 8f;

    private readonly MotionProfile profile;
    private readonly RecordedCycle cycle;
    private readonly Vector3 start;
    private readonly Vector3 drift;

    /// <summary>Takes a movement.</summary>
    public Take(MotionProfile profile, Movement movement, GroundRelief relief)
    {
        this.profile = profile;
        OnGround = movement.Gait != null || profile.Slither != null || movement.Kind is ClipKind.TakeOff or ClipKind.Landing || (movement.Act != null && profile.Legs != null);
        var level = new SteadyMotion(profile, movement, FlatGround.Level);
        level.Settle(SteadyMotion.SettleSeconds);
        float seconds = level.CycleSeconds();
        int strokes = StrokesIn(profile, movement, ref seconds);
        float way = Math.Max(level.Animator.Speed, 0f) * seconds;
        (Vector3 min, Vector3 max) = MotionTrial.Extent(profile.Subject);
        float body = max.Z - min.Z;
        int cycles = OnGround && way > 0f && level.Closes ? (int)Scalar.Clamp((float)Math.Ceiling(ShortestWay * body / way), 1f, MaxCycles) : 1;
        SteadyMotion motion = level;
        IGround ground = FlatGround.Level;
        if (relief == GroundRelief.Rough && OnGround && way > 0f && level.Closes)
        {
            float length = MotionTrial.HillLength(profile, movement);
            cycles = Math.Max(cycles, (int)Math.Ceiling(ShortestPeriod * length / way));
            float around = (2f * body) + (4f * length);
            float far = level.Animator.Speed * (SteadyMotion.SettleSeconds + ((2 + cycles) * (seconds + 1f)));
            ground = new HillField(new Seed(profile.Subject.Seed), length, cycles * way).Around(around, -around, far + around);
            motion = new SteadyMotion(profile, movement, ground);
            motion.Settle(SteadyMotion.SettleSeconds);
        }

        Surface = new CourseSurface(ground);

        // Of fliers that glide between their beats a stroke is a part of what repeats.
        int framesPerCycle = StripFrames * Math.Max(2, (int)Math.Round(Math.Min(seconds * FrameRate, MaxFrames) / StripFrames));
        MomentsPerFrame = ((MinMoments * strokes) + framesPerCycle - 1) / framesPerCycle;
        Frames = framesPerCycle * cycles;
        StrokeMoments = framesPerCycle * MomentsPerFrame / strokes;
        StrokeSeconds = seconds / strokes;
        FrameSeconds = seconds / framesPerCycle;
        float step = FrameSeconds / MomentsPerFrame;
        int settle = framesPerCycle * MomentsPerFrame;
        for (int i = 0; i < settle && motion.Closes; i++)
        {
            motion.Advance(step);
        }

        cycle = new RecordedCycle(motion, Frames * MomentsPerFrame, step);
        Speed = (float)cycle.MeanSpeed;
        start = cycle.PlaceAt(0).Position;
        drift = cycle.PlaceAt(cycle.Frames).Position - start;
        drift.Y = OnGround ? 0f : drift.Y;
        start.Y = OnGround ? 0f : start.Y;
    }

    /// <summary>What it goes on.</summary>
    public CourseSurface Surface { get; }

    /// <summary>Whether it goes on the ground at all.</summary>
    public bool OnGround { get; }

    /// <summary>Frames of the moving picture.</summary>
    public int Frames { get; }

    /// <summary>Moments from frame to frame.</summary>
    public int MomentsPerFrame { get; }

    /// <summary>Seconds from frame to frame.</summary>
    public float FrameSeconds { get; }

    /// <summary>Moments of one cycle of steps, or of one stroke of wings or tail.</summary>
    public int StrokeMoments { get; }

    /// <summary>Seconds of it.</summary>
    public float StrokeSeconds { get; }

    /// <summary>Mean speed, metres per second.</summary>
    public float Speed { get; }

    /// <summary>Number of feet that it goes on.</summary>
    public int Feet => cycle.Feet;

    /// <summary>Way from the first moment to the last, metres along +Z.</summary>
    public float Way => drift.Z;

    /// <summary>What happens, at times counted in frames.</summary>
    public ClipEvent[] Events
    {
        get
        {
            var events = new List<ClipEvent>();
            foreach (ClipEvent one in cycle.EventsAt(1))
            {
                events.Add(new ClipEvent(one.Time / MomentsPerFrame, one.Name, one.Joint, one.Strength));
            }

            return [.. events];
        }
    }

    /// <summary>What the camera has gone by, world space, metres.</summary>
    public Vector3 CameraAt(int moment) => start + (drift * (moment / (float)cycle.Frames));

    /// <summary>How a foot is.</summary>
    public FootReport FootAt(int moment, int foot) => cycle.FootAt(moment, foot);

    /// <summary>Where the joints are as the camera sees them, metres.</summary>
    public Vector3[] JointsAt(int moment)
    {
        Vector3 camera = CameraAt(moment);
        return Array.ConvertAll(MovedSkin.Joints(profile.Subject.Skeleton, cycle.PlaceAt(moment), LocalAt(moment)), joint => joint - camera);
    }

    /// <summary>Skin and normals as the camera sees them, metres.</summary>
    public (Vector3[] Positions, Vector3[] Normals) SkinAt(int moment) =>
        MovedSkin.Of(profile.Subject.Creature!, cycle.PlaceAt(moment), LocalAt(moment), new RootPlace(CameraAt(moment), Quaternion.Identity));

    /// <summary>Where the feet stand, and above which places they swing, as the camera sees them.</summary>
    public ContactMark[] MarksAt(int moment)
    {
        var feet = new FootReport[Feet];
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i] = FootAt(moment, i);
        }

        Vector3 camera = CameraAt(moment);
        return ContactMark.Of(feet, Array.ConvertAll(JointsAt(moment), joint => joint + camera), Surface.Below, new RootPlace(camera, Quaternion.Identity));
    }

    /// <summary>Strokes from one repetition of the whole motion to the next.</summary>
    private static int StrokesIn(MotionProfile profile, Movement movement, ref float seconds)
    {
        if (movement.Kind != ClipKind.Lasting || movement.Input.Medium != MotionMedium.Air || profile.Flight is null)
        {
            return 1;
        }

        int beats = profile.Flight.BeatsPerCycle;
        if (profile.Flight.GlidesBetweenBeats && movement.Input.Speed != 0f)
        {
            return beats;
        }

        seconds /= beats;
        return 1;
    }

    private Pose LocalAt(int moment)
    {
        int first = moment * cycle.Joints;
        return new Pose(cycle.Rotations.AsSpan(first, cycle.Joints), cycle.Positions.AsSpan(first, cycle.Joints));
    }
}
