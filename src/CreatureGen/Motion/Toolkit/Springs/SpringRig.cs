using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Motion.Toolkit.Springs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The joints that swing by themselves: one or more chains, with branches, each from a joint that is animated to its tips. Immutable.</summary>
public sealed class SpringRig
{
    // Bones at the end of a chain without an end joint get a tip of their own: half as long as their parent's.
    private const float VirtualTip = 0.5f;

    private readonly int[] joints;
    private readonly float[] along;
    private readonly int[] ends;
    private readonly SpringJoint[] bones;
    private readonly int[] roots;

    /// <summary>Takes joints with everything that hangs on them.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="roots">First joints that swing; none below another.</param>
    /// <exception cref="ArgumentException">There is no such joint, or one hangs on another.</exception>
    public SpringRig(Skeleton skeleton, ReadOnlySpan<int> roots)
        : this(skeleton, Below(skeleton, roots), Array.Empty<int>())
    {
    }

    /// <summary>Takes some joints.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="swings">Which joints.</param>
    /// <param name="tips">The joint at the tip of each joint's bone; empty for the main children.</param>
    private SpringRig(Skeleton skeleton, bool[] swings, ReadOnlySpan<int> tips)
    {
        Skeleton = skeleton;
        var chosen = new List<int>();
        int[] indexOf = new int[skeleton.Count];
        Array.Fill(indexOf, -1);
        var rigid = new List<int>();
        for (int i = 0; i < skeleton.Count; i++)
        {
            int above = skeleton.Parents[i];
            if (swings[i])
            {
                indexOf[i] = chosen.Count;
                chosen.Add(i);
            }
            else if (above >= 0 && (indexOf[above] >= 0 || rigid.Contains(above)))
            {
                rigid.Add(i);
            }
        }

        ends = rigid.ToArray();
        joints = chosen.ToArray();
        bones = new SpringJoint[joints.Length];
        along = new float[joints.Length];
        float[] end = new float[joints.Length];
        for (int i = 0; i < joints.Length; i++)
        {
            ref SpringJoint bone = ref bones[i];
            bone.Joint = joints[i];
            bone.Carrier = skeleton.Parents[joints[i]];
            bone.Parent = bone.Carrier >= 0 ? indexOf[bone.Carrier] : -1;
            Vector3 way = tips.Length > 0 ? skeleton.LocalPositions[tips[joints[i]]] : Vector3.Zero;
            bone.Length = way == Vector3.Zero ? Tail(skeleton, joints[i]) : Vec.Length(way);
            bone.Direction = Vec.Normalize(way, skeleton.Joints[joints[i]].Along);
            bone.Limit = new LocalLimit(skeleton.Joints[joints[i]]);
            end[i] = bone.Length + (bone.Parent >= 0 ? end[bone.Parent] : 0f);
        }

        // How far out the farthest tip below each bone is, then each bone's own place on the way there.
        float[] farthest = (float[])end.Clone();
        for (int i = joints.Length - 1; i > 0; i--)
        {
            int parent = bones[i].Parent;
            if (parent >= 0)
            {
                farthest[parent] = Math.Max(farthest[parent], farthest[i]);
            }
        }

        for (int i = 0; i < joints.Length; i++)
        {
            farthest[i] = bones[i].Parent >= 0 ? farthest[bones[i].Parent] : farthest[i];
            float before = end[i] - bones[i].Length;
            float last = farthest[i] - bones[Outermost(i)].Length;
            along[i] = last > 0f ? Math.Min(before / last, 1f) : 0f;
            Length = Math.Max(Length, end[i]);
        }

        roots = Array.ConvertAll(Array.FindAll(bones, bone => bone.Parent < 0), bone => bone.Joint);
    }

    /// <summary>Of these joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>The joints that swing, parents first.</summary>
    public ReadOnlySpan<int> Joints => joints;

    /// <summary>Length of the longest chain, model metres.</summary>
    public float Length { get; }

    /// <summary>What is known of each of them.</summary>
    internal ReadOnlySpan<SpringJoint> Bones => bones;

    /// <summary>The joints at which the chains begin.</summary>
    internal ReadOnlySpan<int> Roots => roots;

    /// <summary>What hangs on the joints and does not swing, parents first.</summary>
    internal ReadOnlySpan<int> Ends => ends;

    /// <summary>Place of each bone along its chain, 0 the root, 1 the outermost.</summary>
    internal ReadOnlySpan<float> Places => along;

    /// <summary>All chains of a role, for example both ears: every joint of the role whose parent has another role.</summary>
    public static SpringRig Of(Skeleton skeleton, JointRole role) => new(skeleton, JointRelations.RootsOf(skeleton, role));

    /// <summary>A single chain: each joint the parent of the next; the last is only the tip of the one before. What else hangs on them goes along without swinging.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="chain">Joints from the first that swings to the tip.</param>
    /// <exception cref="ArgumentException">There are fewer than two joints, or one is not the parent of the next.</exception>
    public static SpringRig Along(Skeleton skeleton, ReadOnlySpan<int> chain)
    {
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        if (chain.Length < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"a chain of {chain.Length} joints; expected one that swings and a tip at least"), nameof(chain));
        }

        bool[] swings = new bool[skeleton.Count];
        int[] tips = new int[skeleton.Count];
        for (int k = 0; k < chain.Length; k++)
        {
            if ((uint)chain[k] >= (uint)skeleton.Count || (k > 0 && skeleton.Parents[chain[k]] != chain[k - 1]))
            {
                throw new ArgumentException(FormattableString.Invariant($"chain[{k}] = {chain[k]} is no child of the joint before it; expected a chain without gaps"), nameof(chain));
            }

            if (k > 0)
            {
                swings[chain[k - 1]] = true;
                tips[chain[k - 1]] = chain[k];
            }
        }

        return new SpringRig(skeleton, swings, tips);
    }

    /// <summary>Which joints hang on some, those with them; joints that only end a chain excepted.</summary>
    private static bool[] Below(Skeleton skeleton, ReadOnlySpan<int> roots)
    {
        bool[] isRoot = new bool[skeleton.Count];
        foreach (int root in roots)
        {
            if ((uint)root >= (uint)skeleton.Count)
            {
                throw new ArgumentException(FormattableString.Invariant($"root {root}; expected joints 0 to {skeleton.Count - 1}"), nameof(roots));
            }

            isRoot[root] = true;
        }

        bool[] swings = new bool[skeleton.Count];
        for (int i = 0; i < skeleton.Count; i++)
        {
            int parent = skeleton.Parents[i];
            bool below = parent >= 0 && swings[parent];
            if (below && isRoot[i])
            {
                throw new ArgumentException(FormattableString.Invariant($"joint {i} is a root and hangs on another; expected separate chains"), nameof(roots));
            }

            swings[i] = (below || isRoot[i]) && skeleton.Joints[i].Role != JointRole.End;
        }

        return swings;
    }

    private static float Tail(Skeleton skeleton, int joint)
    {
        if (skeleton.Joints[joint].Length > 0f)
        {
            return skeleton.Joints[joint].Length;
        }

        int parent = skeleton.Parents[joint];
        float length = parent >= 0 ? skeleton.Joints[parent].Length : 0f;
        return length > 0f ? length * VirtualTip : 0.05f;
    }

    /// <summary>The last bone of the line that goes on from a bone through first children.</summary>
    private int Outermost(int bone)
    {
        for (int i = bone + 1; i < joints.Length; i++)
        {
            if (bones[i].Parent == bone)
            {
                bone = i;
            }
        }

        return bone;
    }
}
