using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Events;

/// <summary>What is to be heard of a clip, told by where its joints are at 120 moments a second, not by how they turn.</summary>
internal sealed class PresetTruth
{
    private const float Rate = 120f;

    private readonly Skeleton skeleton;
    private readonly IClip clip;
    private readonly Vector3[][] places;
    private readonly bool loops;

    public PresetTruth(Skeleton skeleton, IClip clip)
    {
        this.skeleton = skeleton;
        this.clip = clip;
        loops = clip.End == ClipEnd.Loops;
        int moments = Math.Max(3, (int)MathF.Round(clip.Duration * Rate));
        var pose = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        places = new Vector3[moments][];
        for (int i = 0; i < moments; i++)
        {
            clip.Sample(clip.Duration * i / moments, pose);
            ForwardKinematics.LocalToModel(skeleton, pose, pose);
            places[i] = pose.Positions.ToArray();
        }
    }

    private float Step => clip.Duration / places.Length;

    /// <summary>Moments at which a wing's end turns down at the top of a beat that goes down by at least 0.3 of its length and of the greatest beat; wings that do so together are one. The animator's own flaps go on through glides.</summary>
    public float[] Flaps()
    {
        var all = new List<float>();
        foreach (int end in Enumerable.Range(0, skeleton.Count).Where(i => skeleton.Joints[i].Role == JointRole.End && skeleton.Joints[skeleton.Parents[i]].Role == JointRole.Wing))
        {
            int root = Root(end);
            float[] height = [.. places.Select(p => p[end].Y - p[root].Y)];
            float least = 0.3f * MathF.Max(Length(root, end), height.Max() - height.Min());
            all.AddRange(Tops(height, least));
        }

        return FirstOfEach(all, 0.05f);
    }

    /// <summary>Moments at which a jaw snaps shut: its end has come back to a fifth of how far it was open, which was at least half of the widest and a sixth of its length, from seven tenths of that within a fifth of a second.</summary>
    public float[] Bites()
    {
        int jaw = Find(JointRole.Jaw);
        if (jaw < 0)
        {
            return [];
        }

        int end = Enumerable.Range(0, skeleton.Count).FirstOrDefault(i => skeleton.Parents[i] == jaw, -1);
        int head = skeleton.Parents[jaw];
        if (end < 0 || head < 0)
        {
            return [];
        }

        // How far its end is from its place at rest, by the distances to the head's joint and to an eye or the head's end.
        int other = Enumerable.Range(0, skeleton.Count).First(i => skeleton.Parents[i] == head && i != jaw && skeleton.Joints[i].Role is JointRole.End or JointRole.Eye);
        float rest = Vector3.Distance(skeleton.ModelPositions[end], skeleton.ModelPositions[other]);
        float length = Vector3.Distance(skeleton.ModelPositions[end], skeleton.ModelPositions[jaw]);
        float[] open = [.. places.Select(p => MathF.Abs(Vector3.Distance(p[end], p[other]) - rest))];
        float least = MathF.Max(length / 6f, 0.5f * open.Max());
        var bites = new List<float>();
        (float widest, int wide) = (0f, 0);
        for (int i = 0; i < open.Length; i++)
        {
            widest = MathF.Max(widest, open[i]);
            wide = open[i] >= 0.7f * widest ? i : wide;
            if (widest > least && open[i] < 0.2f * widest)
            {
                if ((i - wide) * Step <= 0.2f)
                {
                    bites.Add(i * Step);
                }

                widest = 0f;
            }
        }

        return [.. bites];
    }

    /// <summary>Moments at which the ends that beat widest for their length, to 0.6 of the widest, go through the middle of their beat, at half their length in a second at least; ends that do so together are one.</summary>
    public float[] Splashes()
    {
        var ends = Enumerable.Range(0, skeleton.Count).Where(i => skeleton.Joints[i].Role == JointRole.End && Root(i) is >= 0 and int root && skeleton.Joints[root].Role != JointRole.Wing).Select(i => (End: i, Root: Root(i))).ToArray();
        float[] beats = [.. ends.Select(e => Beat(e.Root, e.End).Max(MathF.Abs) / Length(e.Root, e.End))];
        var all = new List<float>();
        for (int i = 0; i < ends.Length; i++)
        {
            if (beats[i] > 0.6f * beats.Max())
            {
                float[] speed = Speed(ends[i].Root, ends[i].End);
                all.AddRange(Crossings(Beat(ends[i].Root, ends[i].End)).Where(t => speed[Math.Min((int)(t / Step), speed.Length - 1)] > 0.5f * Length(ends[i].Root, ends[i].End)));
            }
        }

        all.Sort();
        return [.. all.Where((t, i) => i == 0 || t - all[i - 1] > 0.1f)];
    }

    /// <summary>The first of each group of moments within so many seconds of it.</summary>
    private static float[] FirstOfEach(List<float> all, float within)
    {
        all.Sort();
        var firsts = new List<float>();
        foreach (float t in all)
        {
            if (firsts.Count == 0 || t - firsts[^1] > within)
            {
                firsts.Add(t);
            }
        }

        return [.. firsts];
    }

    private int Find(JointRole role) => Enumerable.Range(0, skeleton.Count).FirstOrDefault(i => skeleton.Joints[i].Role == role, -1);

    /// <summary>The first joint of the tail, fin or body that ends with a joint; −1 if it ends something else.</summary>
    private int Root(int end)
    {
        int root = skeleton.Parents[end];
        JointRole role = skeleton.Joints[root].Role;
        while (skeleton.Parents[root] >= 0 && skeleton.Joints[skeleton.Parents[root]].Role == role)
        {
            root = skeleton.Parents[root];
        }

        return role is JointRole.Tail or JointRole.Fin or JointRole.Spine or JointRole.Wing ? root : -1;
    }

    private float Length(int root, int end) => Vector3.Distance(skeleton.ModelPositions[root], skeleton.ModelPositions[end]);

    private float[] Speed(int root, int end)
    {
        int n = places.Length;
        float[] speeds = new float[n];
        for (int i = 0; i < n; i++)
        {
            int next = i + 1 < n ? i + 1 : loops ? 0 : i;
            speeds[i] = (places[next][end] - places[next][root] - places[i][end] + places[i][root]).Length() / Step;
        }

        return speeds;
    }

    /// <summary>How far an end is from the middle of its beat, along the way to where it is farthest from that: fins that hang aslant beat aslant.</summary>
    private float[] Beat(int root, int end)
    {
        Vector3[] way = [.. places.Select(p => p[end] - p[root])];
        Vector3 low = way.Aggregate(Vector3.Min), high = way.Aggregate(Vector3.Max);
        Vector3 farthest = way.Select(w => w - (0.5f * (low + high))).MaxBy(w => w.LengthSquared());
        Vector3 axis = Vec.Normalize(farthest, Vector3.UnitY);
        float middle = 0.5f * (way.Min(w => Vector3.Dot(w, axis)) + way.Max(w => Vector3.Dot(w, axis)));
        return [.. way.Select(w => Vector3.Dot(w, axis) - middle)];
    }

    /// <summary>Moments of the tops from which a value falls by at least so much before it rises above them again.</summary>
    private List<float> Tops(float[] values, float least)
    {
        int n = values.Length;
        int start = loops ? Array.IndexOf(values, values.Min()) : 0;
        var found = new List<float>();
        (int top, float bottom) = (start, values[start]);
        bool falls = false;
        for (int k = 1; k <= n; k++)
        {
            int i = (start + k) % n;
            if (!loops && start + k >= n)
            {
                break;
            }

            if (falls)
            {
                bottom = MathF.Min(bottom, values[i]);
                (falls, top) = values[i] - bottom > 0.2f * least ? (false, i) : (true, top);
                continue;
            }

            top = values[i] > values[top] ? i : top;
            if (values[top] - values[i] >= least)
            {
                found.Add(top * Step);
                (falls, bottom) = (true, values[i]);
            }
        }

        return found;
    }

    private List<float> Crossings(float[] beat)
    {
        var found = new List<float>();
        for (int i = 0; i < beat.Length; i++)
        {
            float next = i + 1 < beat.Length ? beat[i + 1] : loops ? beat[0] : beat[i];
            if (beat[i] < 0f != next < 0f)
            {
                found.Add((i + (beat[i] / (beat[i] - next))) * Step);
            }
        }

        return found;
    }
}
