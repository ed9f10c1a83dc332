using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Motion.Soak;

/// <summary>
/// Creatures of all kinds that do what they are told for hours: random scripts, settings, frame times, grounds that are flat, hilly, meshes, moving or hostile, teleports, rebases, and being moved by hand.
/// After each update every number that can be read is checked, nothing may have been allocated but room for what happens for the first time, and no update may take longer than some seconds.
/// </summary>
internal sealed class SoakRun(ulong seed)
{
    private const double LongestSecondsOfUpdate = 60;

    private readonly RandomStream order = new(seed);
    private RandomStream random = new(seed);
    private readonly HashSet<(string Who, long Update)> rooms = [];
    private readonly Dictionary<string, long> failures = [];

    private string subject = "";
    private int lastAct;
    private float lastStep;
    private MotionInput lastInput;
    private RootPlace lastRoot;
    private MotionSettings lastSettings;
    private IGround? lastGround;

    /// <summary>Updates made.</summary>
    public long Updates { get; private set; }

    /// <summary>Seconds that passed for the creatures.</summary>
    public double SimulatedSeconds { get; private set; }

    /// <summary>Creatures that were run.</summary>
    public int Creatures { get; private set; }

    /// <summary>Hits that counted as none.</summary>
    public long Refused { get; private set; }

    /// <summary>Exceptions of the ground that came through.</summary>
    public long Thrown { get; private set; }

    /// <summary>The longest update, seconds of the clock.</summary>
    public double Longest { get; private set; }

    /// <summary>What is going on now; null before anything does.</summary>
    public string? Current => lastSettings.Walking is null ? null : FormattableString.Invariant($"{subject}: act {lastAct}, {lastStep} s, {lastInput} over {lastGround}, from {lastRoot.Position} {lastRoot.Rotation} at scale {lastRoot.Scale}, Up {lastSettings.Up}, gravity {lastSettings.Gravity}, responses {lastSettings.Walking.SpeedResponse} and {lastSettings.Walking.YawResponse}, stride {lastSettings.Walking.Stride}, lift {lastSettings.Walking.Lift}");

    /// <summary>What went on when something went wrong first.</summary>
    public string? First { get; private set; }

    /// <summary>What went on at the first exception that is not the ground's, and that exception.</summary>
    public string? FirstException { get; private set; }

    /// <summary>
    /// Updates of one creature that may allocate: room is made when something happens to it for the first time (a ground that may throw, a fall, a landing, going limp, getting up). What allocates beyond is wrong.
    /// </summary>
    public const int MaxRooms = 8;

    /// <summary>Updates that allocated, and whose. Beside other tests some do only because a collection comes in between: never the same in two runs.</summary>
    public IReadOnlySet<(string Who, long Update)> Rooms => rooms;

    /// <summary>What went wrong, and how often.</summary>
    public IReadOnlyDictionary<string, long> Failures => failures;

    /// <summary>Runs creatures one after another until so many seconds have passed for them.</summary>
    public void Run(double simulatedSeconds, double secondsEach)
    {
        while (SimulatedSeconds < simulatedSeconds)
        {
            ulong creature = order.NextUInt64();
            var kind = (LocomotionKind)(Creatures++ % 3);
            RunOne(creature, kind, Math.Min(simulatedSeconds, SimulatedSeconds + secondsEach));
        }
    }

    /// <summary>Runs one creature again as it was run among the others.</summary>
    public void RunOne(ulong creature, LocomotionKind kind, double until)
    {
        // What happens to a creature depends on its own seed alone, so that it can be run again by itself.
        random = new RandomStream(creature);
        var profile = new MotionProfile(CreatureGenerator.Generate(creature, CreatureOptions.Default with { Kind = RequestedKind.Walking + (int)kind }));
        var animator = new CreatureAnimator(profile);
        var hostile = new HostileGround(Relief(), new RandomStream(creature + 1));
        IGround[] grounds = { FlatGround.Level, Relief(), hostile };
        while (SimulatedSeconds < until)
        {
            IGround ground = grounds[random.Integer(0, grounds.Length)];
            hostile.Malice = random.Chance(0.5) ? 0.02 : 0.5;
            hostile.Fury = random.Chance(0.2) ? 0.02 : 0;
            animator.Settings = Settings(animator);
            animator.LookAt = random.Chance(0.5) ? null : Place(20);
            MotionInput input = Input();
            int frames = random.Integer(20, 400);
            double pace = Math.Pow(10, random.Uniform(-3, -0.6));
            for (int i = 0; i < frames && SimulatedSeconds < until; i++)
            {
                float dt = random.Chance(0.02) ? 0f : random.Chance(0.01) ? 3f : (float)(pace * random.Uniform(0.3, 1.7));
                Step(animator, dt, input, ground, FormattableString.Invariant($"{kind} {creature}"));
                SimulatedSeconds += Math.Min(dt, 0.25f);
                input = random.Chance(0.01) ? Input() : input;
            }
        }
    }

    private void Step(CreatureAnimator animator, float dt, in MotionInput input, IGround ground, string who)
    {
        int act = random.Integer(0, 400);
        (subject, lastAct, lastStep, lastInput, lastRoot, lastSettings, lastGround) = (who, act, dt, input, animator.Root, animator.Settings, ground);
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long start = Stopwatch.GetTimestamp();
        bool thrown = false;
        try
        {
            switch (act)
            {
                case 0:
                    animator.Teleport(new RootPlace(Place(100), Turn(), (float)Math.Pow(10, random.Uniform(-2, 2))), ground);
                    break;
                case 1:
                    animator.Rebase(-animator.Root.Position);
                    break;
                case < 20:
                    animator.Follow(dt, new RootPlace(animator.Root.Position + (Place(1) * dt), animator.Root.Rotation, animator.Root.Scale), ground);
                    break;
                default:
                    animator.Update(dt, input, ground);
                    break;
            }
        }
        catch (InvalidOperationException problem) when (ReferenceEquals(problem, HostileGround.Thrown))
        {
            thrown = true;
            Thrown++;
        }
        catch (Exception problem)
        {
            FirstException ??= Current + "\n" + problem;
            Count(who + ": " + problem.GetType().Name + ": " + problem.Message);
        }

        double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        long allocated = GC.GetAllocatedBytesForCurrentThread() - bytes;
        Updates++;
        Refused += animator.RefusedHits;
        Longest = Math.Max(Longest, seconds);
        if (seconds > LongestSecondsOfUpdate)
        {
            Count(who + FormattableString.Invariant($": an update took {seconds:0.0} s"));
        }

        if (allocated != 0 && !thrown)
        {
            rooms.Add((who, Updates));
        }

        Check(animator, who);
    }

    private void Check(CreatureAnimator animator, string who)
    {
        Pose local = animator.LocalPose;
        Pose model = animator.ModelPose;
        for (int i = 0; i < local.Rotations.Length; i++)
        {
            if (!(IsTurn(local.Rotations[i]) && IsTurn(model.Rotations[i]) && IsFinite(local.Positions[i]) && IsFinite(model.Positions[i])))
            {
                Count(who + ": the pose of " + animator.Profile.Subject.Skeleton.Joints[i].Name + " is no pose");
                break;
            }
        }

        if (!(IsFinite(animator.Root.Position) && IsTurn(animator.Root.Rotation) && float.IsFinite(animator.Speed) && float.IsFinite(animator.Phase) && float.IsFinite(animator.Frequency)))
        {
            Count(who + ": root, speed or phase is not finite");
        }

        for (int f = 0; f < animator.FootCount; f++)
        {
            FootReport foot = animator.Foot(f);
            if (!(float.IsFinite(foot.Load) && IsFinite(foot.Place)))
            {
                Count(who + ": a foot is not finite");
            }
        }

        foreach (MotionEvent happened in animator.Events)
        {
            if (!(IsFinite(happened.Position) && float.IsFinite(happened.Strength)))
            {
                Count(who + ": an event is not finite");
            }
        }
    }

    private void Count(string failure)
    {
        First ??= Current;
        failures[failure] = failures.GetValueOrDefault(failure) + 1;
    }

    private static bool IsFinite(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);

    private static bool IsTurn(Quaternion q) => Math.Abs(q.LengthSquared() - 1f) < 1e-3f;

    private MotionInput Input()
    {
        if (random.Chance(0.2))
        {
            return default;
        }

        double fastest = random.Chance(0.05) ? 1e4 : random.Chance(0.3) ? 30 : 3;
        return new MotionInput(
            (float)random.Uniform(-0.4 * fastest, fastest),
            random.Chance(0.5) ? 0f : (float)random.Uniform(-3, 3) * (random.Chance(0.05) ? 300f : 1f),
            random.Chance(0.7) ? 0f : (float)random.Uniform(-fastest, fastest),
            random.Chance(0.5) ? 0f : (float)random.Uniform(-fastest, fastest),
            random.Chance(0.5) ? MotionMedium.Air : MotionMedium.Ground,
            (EscapeTurn)random.Integer(0, 3));
    }

    private MotionSettings Settings(CreatureAnimator animator)
    {
        MotionSettings s = MotionSettings.Default;
        if (random.Chance(0.5))
        {
            s.Up = random.Chance(0.3) ? Vector3.Normalize(Place(1) + (2f * Vector3.UnitY)) : s.Up;
            s.Gravity = (float)Math.Pow(10, random.Uniform(-1, 3));
            s.Walking = new WalkingSettings
            {
                SpeedResponse = (float)Math.Pow(10, random.Uniform(-1, 2)),
                YawResponse = (float)Math.Pow(10, random.Uniform(-1, 2)),
                Lift = (float)random.Uniform(0, 4),
                Bounce = (float)random.Uniform(0, 4),
                Sway = (float)random.Uniform(0, 4),
                SpineMotion = (float)random.Uniform(0, 2),
                HeadSteadiness = (float)random.Uniform(0, 1.3),
                TailMotion = (float)random.Uniform(0, 4),
                Bank = (float)random.Uniform(0, 2),
                Stride = (float)random.Uniform(0.3, 1.5),
                Traction = (float)random.Uniform(0.05, 3),
            };
            s.Idle = (float)random.Uniform(0, 4);
            s.Slithering = new SlitheringSettings { Gait = (SlitherGait)random.Integer(0, 3), SpeedResponse = Factor() };
            s.Flying = new FlyingSettings { SpeedResponse = Factor(), YawResponse = Factor(), Bank = (float)random.Uniform(0, 2), BeatAmplitude = (float)random.Uniform(0.5, 1.5) };
            s.Swimming = new SwimmingSettings { SpeedResponse = Factor(), YawResponse = Factor(), Bank = (float)random.Uniform(0, 2), BeatAmplitude = (float)random.Uniform(0.3, 1.5) };
        }

        return s;

        float Factor() => (float)random.Uniform(0.25, 4);
    }

    private Vector3 Place(double size) => new((float)random.Uniform(-size, size), (float)random.Uniform(-size, size), (float)random.Uniform(-size, size));

    private Quaternion Turn() => Quaternion.Normalize(new Quaternion(0.2f * Place(1), 1.1f));

    /// <summary>A field of steep bumps, or the mesh of one, with an edge to fall over.</summary>
    private IGround Relief()
    {
        const int Side = 40;
        float cell = (float)random.Uniform(0.05, 2);
        var heights = new float[Side * Side];
        var positions = new Vector3[heights.Length];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = (float)random.Uniform(0, 1.5) * cell;
            positions[i] = new Vector3(((i % Side) - (Side / 2)) * cell, heights[i], ((i / Side) - (Side / 2)) * cell);
        }

        if (random.Chance(0.5))
        {
            return new HeightFieldGround(heights, Side, cell, new Vector3(-Side / 2 * cell, 0f, -Side / 2 * cell));
        }

        var triangles = new List<int>();
        for (int k = 0; k < Side - 1; k++)
        {
            for (int i = 0; i < Side - 1; i++)
            {
                int a = (k * Side) + i;
                triangles.AddRange([a, a + Side, a + 1, a + 1, a + Side, a + Side + 1]);
            }
        }

        return new MeshGround(positions, triangles.ToArray());
    }
}
