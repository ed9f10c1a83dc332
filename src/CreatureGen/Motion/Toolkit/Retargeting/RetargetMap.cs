using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Retargeting;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Which joints of one skeleton do what joints of another do, and how their rest poses differ. Worked out once, for any number of clips. Immutable.</summary>
/// <remarks>
/// Joints are matched by their roles (<see cref="Skeleton.Build"/> tells them from names and tree): what carries the body, trunk, neck, head and tail by the part of the way along them, limbs by side and by their order from behind.
/// Limbs are turned from their own rest to the rest of those that they follow, each as a whole from hip to end: arms from hanging to a T, and a leg keeps the bends it stands with. Both skeletons face +Z with +Y up.
/// </remarks>
public sealed class RetargetMap
{
    private readonly List<RetargetedJoint> joints = new();
    private readonly List<RetargetedLeg> legs = new();

    /// <summary>A leg's end is a foot if it is this near the ground at rest, parts of the hip's height.</summary>
    private const float FootHeight = 0.35f;

    /// <summary>Matches two skeletons.</summary>
    /// <param name="from">Of the clips.</param>
    /// <param name="to">That is to move like them.</param>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    /// <exception cref="ArgumentException">They have neither a limb nor a trunk in common, or nothing that carries the body.</exception>
    public RetargetMap(Skeleton from, Skeleton to)
    {
        From = from ?? throw new ArgumentNullException(nameof(from));
        To = to ?? throw new ArgumentNullException(nameof(to));
        var source = new SkeletonRoles(from);
        var target = new SkeletonRoles(to);
        if (source.Carrier < 0 || target.Carrier < 0)
        {
            Skeleton lacks = source.Carrier < 0 ? from : to;
            throw new ArgumentException(FormattableString.Invariant($"the skeleton of {lacks.Count} joints from {lacks.Joints[0].Name} has no joint of the role {JointRole.Body} or {JointRole.Pelvis}; expected one that carries the body"), source.Carrier < 0 ? nameof(from) : nameof(to));
        }

        FromCarrier = source.Carrier;
        ToCarrier = target.Carrier;
        Scale = 1f;
        AddLimbs(source, target);
        Add(source.Trunk, target.Trunk);
        Add(source.Neck, target.Neck);
        Add(source.Head, target.Head);
        Add(source.Tail, target.Tail);
        if (joints.Count == 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"skeletons of {from.Count} and {to.Count} joints that have no role in common; expected a trunk or a limb in both"), nameof(to));
        }

        if (!joints.Exists(one => one.Joint == ToCarrier))
        {
            joints.Add(new RetargetedJoint(ToCarrier, FromCarrier, FromCarrier, 0f, Quaternion.Identity));
        }

        joints.Sort((a, b) => a.Joint.CompareTo(b.Joint));
    }

    /// <summary>The skeleton of the clips.</summary>
    public Skeleton From { get; }

    /// <summary>The skeleton that is to move like them.</summary>
    public Skeleton To { get; }

    /// <summary>Metres of the second for each of the first: the ratio of their legs, or of their heights where none match.</summary>
    public float Scale { get; private set; }

    /// <summary>Number of joints that follow others.</summary>
    public int Count => joints.Count;

    internal int FromCarrier { get; }

    internal int ToCarrier { get; }

    internal IReadOnlyList<RetargetedJoint> Joints => joints;

    internal IReadOnlyList<RetargetedLeg> Legs => legs;

    /// <summary>The joint of the second skeleton that does what a joint of the first does; −1 for none.</summary>
    /// <param name="joint">Index in the first skeleton.</param>
    public int JointFor(int joint)
    {
        foreach (RetargetedJoint one in joints)
        {
            if (one.Before == joint && one.Part < 0.5f)
            {
                return one.Joint;
            }
        }

        return -1;
    }

    private void AddLimbs(SkeletonRoles source, SkeletonRoles target)
    {
        float lengths = 0f;
        float others = 0f;
        foreach ((int[] limb, Anatomy.Side side, int pair) in target.Limbs)
        {
            foreach ((int[] other, Anatomy.Side otherSide, int otherPair) in source.Limbs)
            {
                if (side != otherSide || pair != otherPair)
                {
                    continue;
                }

                (int last, int otherLast) = EndsOf(limb, other);
                Quaternion align = Rotation.FromTo(
                    To.ModelPositions[limb[last]] - To.ModelPositions[limb[0]],
                    From.ModelPositions[other[otherLast]] - From.ModelPositions[other[0]]);
                int before = other[0];
                for (int k = 0; k < limb.Length; k++)
                {
                    int follows = k == last ? otherLast : Math.Min(k, otherLast);
                    before = other[follows] < 0 ? before : other[follows];
                    if (limb[k] >= 0)
                    {
                        joints.Add(new RetargetedJoint(limb[k], before, before, 0f, align));
                    }
                }

                if (last > 0 && IsFoot(To, limb[0], limb[last]) && IsFoot(From, other[0], other[otherLast]))
                {
                    legs.Add(new RetargetedLeg(ChainOf(To, limb[0], limb[last]), other[otherLast]));
                    lengths += To.ModelPositions[limb[0]].Y - To.ModelPositions[limb[last]].Y;
                    others += From.ModelPositions[other[0]].Y - From.ModelPositions[other[otherLast]].Y;
                }
            }
        }

        Scale = others > 0f && lengths > 0f ? lengths / others : HeightOf(To) / HeightOf(From);
        for (int i = joints.Count - 1; i >= 0; i--)
        {
            (int girdle, int other) = (target.GirdleOf(joints[i].Joint), source.GirdleOf(joints[i].Before));
            if (girdle >= 0 && other >= 0)
            {
                joints.Add(new RetargetedJoint(girdle, other, other, 0f, Quaternion.Identity, Scale));
            }
        }
    }

    /// <summary>The joints that two limbs end with, as places in them: the same in both, or of legs of which only one has a ball those that are as near to the ground.</summary>
    private (int Last, int OtherLast) EndsOf(int[] limb, int[] other)
    {
        const int ankle = 2;
        const int ball = 3;
        if (limb[ankle] >= 0 && other[ankle] >= 0 && (limb[ball] < 0) != (other[ball] < 0) && IsFoot(To, limb[0], limb[ankle]) && IsFoot(From, other[0], other[ankle]))
        {
            float mine = HeightIn(To, limb, ankle);
            float others = HeightIn(From, other, ankle);
            if (limb[ball] < 0 && Math.Abs(HeightIn(From, other, ball) - mine) < Math.Abs(others - mine))
            {
                return (ankle, ball);
            }

            if (other[ball] < 0 && Math.Abs(HeightIn(To, limb, ball) - others) < Math.Abs(mine - others))
            {
                return (ball, ankle);
            }
        }

        int last = ball;
        while (last > 0 && (limb[last] < 0 || other[last] < 0))
        {
            last--;
        }

        return (last, last);
    }

    /// <summary>How high a joint of a limb is at rest, parts of its hip's height.</summary>
    private static float HeightIn(Skeleton skeleton, int[] limb, int place) => skeleton.ModelPositions[limb[place]].Y / skeleton.ModelPositions[limb[0]].Y;

    private static bool IsFoot(Skeleton skeleton, int hip, int end) => skeleton.ModelPositions[end].Y < FootHeight * skeleton.ModelPositions[hip].Y;

    private static float HeightOf(Skeleton skeleton)
    {
        float low = float.MaxValue;
        float high = float.MinValue;
        foreach (Vector3 p in skeleton.ModelPositions)
        {
            low = Math.Min(low, p.Y);
            high = Math.Max(high, p.Y);
        }

        return Math.Max(high - low, Tolerance.DirectionLength);
    }

    private static int[] ChainOf(Skeleton skeleton, int first, int last)
    {
        var chain = new List<int>();
        for (int at = last; at >= first; at = skeleton.Parents[at])
        {
            chain.Insert(0, at);
        }

        return chain.ToArray();
    }

    private void Add(IReadOnlyList<(int Joint, float Part)> source, IReadOnlyList<(int Joint, float Part)> target)
    {
        foreach ((int joint, float part) in target)
        {
            if (source.Count == 0)
            {
                return;
            }

            int after = 0;
            while (after < source.Count - 1 && source[after].Part < part)
            {
                after++;
            }

            int before = Math.Max(after - 1, 0);
            float span = source[after].Part - source[before].Part;
            joints.Add(new RetargetedJoint(joint, source[before].Joint, source[after].Joint, span > 0f ? Scalar.Clamp((part - source[before].Part) / span, 0f, 1f) : 0f, Quaternion.Identity));
        }
    }
}
