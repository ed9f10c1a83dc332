using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>Finds the moments of an <see cref="AngularRule"/> while a motion goes on: in the poses of an animator, a ragdoll or any other stream. Nothing is allocated per update.</summary>
/// <remarks>
/// Latency: a moment is known when the acceleration, or the speed of a sweep any way, has fallen from its maximum below the threshold or by half, one update after it at best, a sixth of a beat for slow ones; with a <see cref="AngularRule.ChunkGap"/> that much later, when a higher peak could still come. It is told in
/// that update, and <see cref="AngularMoment.SecondsAgo"/> says how long ago it was: at 60 updates a second 25 ms, half an update of which is the place of the acceleration between two updates. <see cref="AngularRule.ThresholdFraction"/>
/// is of the greatest acceleration lately, which is forgotten by half in <see cref="Memory"/> seconds. Beginnings of sweeps are told when they have lasted for a seventh of a usual sweep; the first stroke teaches how fast the limb usually sweeps. Of an interval the earliest stays, since a stronger one may come only later. <see cref="AngularRule.Offset"/> is
/// added to <see cref="AngularMoment.SecondsAgo"/>, at most to 0.
/// </remarks>
public sealed class AngularEventStream
{
    /// <summary>Seconds after which the greatest acceleration counts for half.</summary>
    public const float Memory = 4f;

    private readonly Skeleton skeleton;
    private readonly AngularRule rule;
    private readonly int[] joints;
    private readonly Track[] tracks;
    private readonly SweepLine[] lines;
    private readonly SweepTrack[] sweeps;
    private readonly SweepEnd[] ends;
    private readonly AngularMoment[] found;
    private int count;
    private float time;
    private float lastTogether = float.NegativeInfinity;
    private int updates;
    private float maxOfAll;

    /// <summary>Begins to listen.</summary>
    /// <param name="skeleton">Of the poses to come.</param>
    /// <param name="rule">What to look for.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The rule names a joint that is not there or none at all, or a number of it is outside its range.</exception>
    public AngularEventStream(Skeleton skeleton, AngularRule rule)
    {
        this.skeleton = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        this.rule = rule ?? throw new ArgumentNullException(nameof(rule));
        rule.Require();
        joints = RuleJoints.Of(skeleton, rule);
        tracks = new Track[joints.Length];
        lines = rule.Sweep is { } sweep ? SweepLine.All(skeleton, joints, sweep) : Array.Empty<SweepLine>();
        sweeps = new SweepTrack[lines.Length];
        ends = new SweepEnd[lines.Length];
        found = new AngularMoment[joints.Length];
    }

    /// <summary>What was found in the last update.</summary>
    public ReadOnlySpan<AngularMoment> Found => found.AsSpan(0, count);

    /// <summary>Takes the next pose.</summary>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">The same in model space.</param>
    /// <param name="dt">Seconds since the last; 0 changes nothing.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, or the time step is negative or not a number.</exception>
    public void Update(in Pose local, in Pose model, float dt)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        Finite.RequireStep(dt);
        count = 0;
        if (dt == 0f)
        {
            return;
        }

        time += dt;
        updates++;
        maxOfAll *= Damping.Left(0.6931472f / Memory, dt);
        for (int j = 0; j < lines.Length; j++)
        {
            if (rule.Sweep!.IsAnyWay)
            {
                SweepEnd end = lines[j].End(skeleton, model);
                if (updates > 1)
                {
                    Listen(ref tracks[j], lines[j].To, rule.Sweep.Speed(ends[j], end, 1f / dt), time - (0.5f * dt), dt);
                }

                ends[j] = end;
            }
            else if (sweeps[j].Passes(Vec.Dot(lines[j].End(skeleton, model).About, rule.Sweep.Towards), dt, rule, out float strength, out float ago))
            {
                Tell(ref tracks[j], lines[j].To, time - ago, strength);
            }
        }

        if (rule.Sweep != null)
        {
            return;
        }

        Span<Quaternion> rotations = rule.Space == AngularSpace.Model ? model.Rotations : local.Rotations;
        for (int j = 0; j < joints.Length; j++)
        {
            Advance(ref tracks[j], rotations[joints[j]], j, dt);
        }
    }

    /// <summary>Forgets what was, after a jump to another pose.</summary>
    public void Reset()
    {
        Array.Clear(tracks, 0, tracks.Length);
        Array.Clear(sweeps, 0, sweeps.Length);
        Array.Clear(ends, 0, ends.Length);
        count = 0;
        time = 0f;
        lastTogether = float.NegativeInfinity;
        updates = 0;
        maxOfAll = 0f;
    }

    private void Advance(ref Track track, Quaternion now, int j, float dt)
    {
        if (updates == 1)
        {
            track = new Track { Rotation = now, Told = float.NegativeInfinity };
            return;
        }

        Vector3 turn = AngularCurve.Turn(track.Rotation, now, rule.Measure) / dt;
        float acceleration = updates == 2 ? 0f : AngularCurve.Change(track.Velocity, turn, rule) * 2f / (dt + track.Step);
        if (rule.NearRest < 1f)
        {
            float turned = AngularCurve.FromRest(track.Rotation, rule.RestOf(skeleton, joints[j]));
            track.Farthest = Math.Max(track.Farthest * Damping.Left(0.6931472f / Memory, dt), turned);
            acceleration = turned > rule.NearRest * track.Farthest ? -Math.Abs(acceleration) : acceleration;
        }

        Listen(ref track, joints[j], acceleration, time - dt, dt);
        track.Rotation = now;
        track.Velocity = turn;
        track.Step = dt;
    }

    /// <summary>Takes the next value of what the rule looks at.</summary>
    private void Listen(ref Track track, int joint, float signal, float at, float dt)
    {
        track.Max = Math.Max(track.Max * Damping.Left(0.6931472f / Memory, dt), signal);
        maxOfAll = Math.Max(maxOfAll, signal);
        float threshold = Math.Max((float)rule.Threshold, rule.ThresholdFraction * (rule.FractionScope == IntervalScope.Together ? maxOfAll : track.Max));
        if (signal >= threshold && signal > 0f)
        {
            if (!track.Above || signal > track.Peak)
            {
                track.Peak = signal;
                track.PeakTime = at;
                track.PeakThreshold = threshold;
            }

            track.Above = true;
            track.LastAbove = at;
        }

        bool falls = track.Above && (signal < threshold || signal < 0.5f * track.Peak);
        if (falls && !track.IsTold && at - track.LastAbove >= (signal < threshold ? rule.ChunkGap : 0f))
        {
            track.IsTold = true;
            Tell(ref track, joint, track.PeakTime, track.PeakThreshold > 0f ? track.Peak / track.PeakThreshold : 1f);
        }

        if (signal < threshold && at - track.LastAbove >= rule.ChunkGap)
        {
            track.Above = track.IsTold = false;
        }
    }

    private void Tell(ref Track track, int joint, float at, float strength)
    {
        float last = rule.Scope == IntervalScope.EachJoint ? track.Told : lastTogether;
        if (at - last < rule.Interval)
        {
            return;
        }

        track.Told = lastTogether = at;
        found[count++] = new AngularMoment(joint, strength, Math.Max(time - at - rule.Offset, 0f));
    }

    private struct Track
    {
        public Quaternion Rotation;
        public Vector3 Velocity;
        public float Step;
        public float Farthest;
        public float Max;
        public float Peak;
        public float PeakTime;
        public float PeakThreshold;
        public float LastAbove;
        public float Told;
        public bool Above;
        public bool IsTold;
    }
}
