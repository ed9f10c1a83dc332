using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>Finds moments in clips by an <see cref="AngularRule"/>.</summary>
/// <remarks>
/// The clip is sampled at an even rate. Of each joint, ω = 2 log(q₁ q₀⁻¹) / dt from sample to sample and α = |ω₁ − ω₀| / dt at each; every stretch of α above the threshold gives the place of its maximum, between
/// samples by the parabola through it and its neighbours; of a rule with a <see cref="AngularRule.Sweep"/> the beginning of each stroke, between samples by a straight line, or where it is fastest. A clip that loops has no ends: a stretch may begin before the last sample and end behind the first.
/// </remarks>
public static class AngularEventDetector
{
    /// <summary>Samples per second of clips that are not recorded frame by frame.</summary>
    public const float UsualRate = 60f;

    /// <summary>Most samples that a clip is taken in.</summary>
    private const int MaxSamples = 1 << 20;

    /// <summary>Finds the moments of a clip.</summary>
    /// <param name="clip">The motion; recorded clips are sampled at their own frames.</param>
    /// <param name="skeleton">Its skeleton.</param>
    /// <param name="rule">What to look for.</param>
    /// <returns>Moments in the order of time, and the curves that they come from.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The clip is of another skeleton, the rule names a joint that is not there or none at all, or a number of the rule is outside its range.</exception>
    public static AngularFinding Find(IClip clip, Skeleton skeleton, AngularRule rule)
    {
        _ = clip ?? throw new ArgumentNullException(nameof(clip));
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        (rule ?? throw new ArgumentNullException(nameof(rule))).Require();
        if (clip.Joints != skeleton.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} has {clip.Joints} joints; expected the {skeleton.Count} of the skeleton"), nameof(clip));
        }

        int[] joints = RuleJoints.Of(skeleton, rule);
        ClipEdge edge = clip.End == ClipEnd.Loops ? ClipEdge.Joined : ClipEdge.Open;
        double wanted = clip.Duration * (clip is Clip recorded ? recorded.Rate : UsualRate);
        if (!(wanted < MaxSamples))
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} lasts {clip.Duration} s; expected fewer than {MaxSamples} samples"), nameof(clip));
        }

        int steps = Math.Max(2, (int)Math.Round(wanted));
        var moments = new List<Moment>();
        AngularCurve[] curves = rule.Sweep == null ? Turning(clip, skeleton, rule, joints, steps, edge, moments) : Sweeping(clip, skeleton, rule, joints, steps, edge, moments);
        return new AngularFinding(Finish(moments, curves, clip, rule), curves);
    }

    private static AngularCurve[] Turning(IClip clip, Skeleton skeleton, AngularRule rule, int[] joints, int steps, ClipEdge edge, List<Moment> moments)
    {
        Quaternion[] rotations = Sample(clip, skeleton, rule.Space, joints, steps, edge, out int samples);
        var curves = new AngularCurve[joints.Length];
        for (int j = 0; j < joints.Length; j++)
        {
            curves[j] = AngularCurve.Of(skeleton.Joints[joints[j]].Name, rotations.AsSpan(j * samples, samples), rule.RestOf(skeleton, joints[j]), steps / clip.Duration, edge, rule);
        }

        FindPeaks(curves, rule, edge, moments);
        return curves;
    }

    private static AngularCurve[] Sweeping(IClip clip, Skeleton skeleton, AngularRule rule, int[] joints, int steps, ClipEdge edge, List<Moment> moments)
    {
        int samples = edge == ClipEdge.Joined ? steps : steps + 1;
        SweepLine[] lines = SweepLine.All(skeleton, joints, rule.Sweep!);
        var ends = new SweepEnd[lines.Length * samples];
        var pose = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        for (int i = 0; i < samples; i++)
        {
            clip.Sample(clip.Duration * i / steps, pose);
            ForwardKinematics.LocalToModel(skeleton, pose, pose);
            for (int j = 0; j < lines.Length; j++)
            {
                ends[(j * samples) + i] = lines[j].End(skeleton, pose);
            }
        }

        var curves = new AngularCurve[lines.Length];
        for (int j = 0; j < lines.Length; j++)
        {
            curves[j] = AngularCurve.Of(skeleton.Joints[lines[j].To].Name, ends.AsSpan(j * samples, samples), steps / clip.Duration, edge, rule.Sweep!);
        }

        if (rule.Sweep!.IsAnyWay)
        {
            FindPeaks(curves, rule, edge, moments);
        }
        else
        {
            for (int j = 0; j < curves.Length; j++)
            {
                Strokes.Find(curves[j], j, rule, edge, moments);
            }
        }

        return curves;
    }

    private static void FindPeaks(AngularCurve[] curves, AngularRule rule, ClipEdge edge, List<Moment> moments)
    {
        float[] max = Array.ConvertAll(curves, Chunks.MaxOf);
        float all = 0f;
        foreach (float one in max)
        {
            all = Math.Max(all, one);
        }

        for (int j = 0; j < curves.Length; j++)
        {
            Chunks.Find(curves[j], j, rule.FractionScope == IntervalScope.Together ? all : max[j], rule, edge, moments);
        }
    }

    /// <summary>The rotations of each joint in turn, in the space of the rule.</summary>
    private static Quaternion[] Sample(IClip clip, Skeleton skeleton, AngularSpace space, int[] joints, int steps, ClipEdge edge, out int samples)
    {
        samples = edge == ClipEdge.Joined ? steps : steps + 1;
        var rotations = new Quaternion[joints.Length * samples];
        var pose = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        for (int i = 0; i < samples; i++)
        {
            clip.Sample(clip.Duration * i / steps, pose);
            if (space == AngularSpace.Model)
            {
                ForwardKinematics.LocalToModel(skeleton, pose, pose);
            }

            for (int j = 0; j < joints.Length; j++)
            {
                rotations[(j * samples) + i] = pose.Rotations[joints[j]];
            }
        }

        return rotations;
    }

    private static ClipEvent[] Finish(List<Moment> moments, AngularCurve[] curves, IClip clip, AngularRule rule)
    {
        float loop = clip.End == ClipEnd.Loops ? clip.Duration : 0f;
        moments.Sort((a, b) => a.Time != b.Time ? a.Time.CompareTo(b.Time) : a.Curve.CompareTo(b.Curve));
        var kept = new List<Moment>();
        int scopes = rule.Scope == IntervalScope.EachJoint ? curves.Length : 1;
        for (int scope = 0; scope < scopes; scope++)
        {
            List<Moment> of = rule.Scope == IntervalScope.EachJoint ? moments.FindAll(m => m.Curve == scope) : moments;
            foreach (int i in Moments.Thin(of.ConvertAll(m => m.Time), of.ConvertAll(m => m.Strength), rule.Interval, rule.Winner, loop))
            {
                kept.Add(of[i]);
            }
        }

        var events = new List<ClipEvent>();
        foreach (Moment moment in kept)
        {
            float time = ClipTime.Within(moment.Time + rule.Offset, clip.Duration, clip.End);
            events.Add(new ClipEvent(time, rule.Name, curves[moment.Curve].Joint, moment.Strength));
        }

        events.Sort((a, b) => a.Time != b.Time ? a.Time.CompareTo(b.Time) : string.CompareOrdinal(a.Joint, b.Joint));
        return events.ToArray();
    }
}
