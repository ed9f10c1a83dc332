using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Retargeting;

/// <summary>The parts of a skeleton as the roles of its joints tell them: what carries it, its trunk, neck, head, tail and limbs.</summary>
internal sealed class SkeletonRoles
{
    private static readonly JointRole[] limbRoles = { JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball };

    private readonly JointRole[] roles;
    private readonly Side[] sides;

    /// <summary>Finds them.</summary>
    public SkeletonRoles(Skeleton skeleton)
    {
        Skeleton = skeleton;
        roles = skeleton.Joints.Select(joint => joint.Role).ToArray();
        sides = skeleton.Joints.Select(joint => joint.Side).ToArray();
        Carrier = First(JointRole.Body);
        Carrier = Carrier < 0 ? First(JointRole.Pelvis) : Carrier;
        int pelvis = First(JointRole.Pelvis);
        pelvis = pelvis < 0 ? Carrier : pelvis;
        Trunk = Along(pelvis, JointRole.Pelvis, JointRole.Spine, JointRole.Chest);
        Neck = Along(pelvis, JointRole.Neck);
        Head = Along(pelvis, JointRole.Head);
        Tail = Along(pelvis, JointRole.Tail);
        Limbs = FindLimbs(pelvis);
    }

    public Skeleton Skeleton { get; }

    /// <summary>The joint that moves with the whole body; −1 if there is none.</summary>
    public int Carrier { get; }

    /// <summary>Joints in the order from the pelvis, with their parts of the way, 0..1.</summary>
    public IReadOnlyList<(int Joint, float Part)> Trunk { get; }

    /// <inheritdoc cref="Trunk"/>
    public IReadOnlyList<(int Joint, float Part)> Neck { get; }

    /// <inheritdoc cref="Trunk"/>
    public IReadOnlyList<(int Joint, float Part)> Head { get; }

    /// <inheritdoc cref="Trunk"/>
    public IReadOnlyList<(int Joint, float Part)> Tail { get; }

    /// <summary>Limbs with a joint for each of hip, knee, ankle and ball, −1 for none; each with its side and its pair, 0 being the hindmost.</summary>
    public IReadOnlyList<(int[] Joints, Side Side, int Pair)> Limbs { get; }

    /// <summary>The girdle that carries a limb; −1 if its hip is on the trunk itself.</summary>
    public int GirdleOf(int hip)
    {
        int parent = Skeleton.Parents[hip];
        return parent >= 0 && roles[parent] == JointRole.Girdle ? parent : -1;
    }

    private int First(JointRole role)
    {
        for (int i = 0; i < Skeleton.Count; i++)
        {
            if (roles[i] == role)
            {
                return i;
            }
        }

        return -1;
    }

    private List<(int Joint, float Part)> Along(int pelvis, params JointRole[] wanted)
    {
        var found = new List<(int Joint, float Part)>();
        float farthest = 0f;
        for (int i = 0; i < Skeleton.Count; i++)
        {
            if (Array.IndexOf(wanted, roles[i]) >= 0 && sides[i] == Side.Median)
            {
                float away = pelvis < 0 ? 0f : Vec.Distance(Skeleton.ModelPositions[pelvis], Skeleton.ModelPositions[i]);
                found.Add((i, away));
                farthest = Math.Max(farthest, away);
            }
        }

        found.Sort((a, b) => a.Part != b.Part ? a.Part.CompareTo(b.Part) : a.Joint.CompareTo(b.Joint));
        float nearest = found.Count > 0 ? found[0].Part : 0f;
        return found.ConvertAll(one => (one.Joint, farthest > nearest ? (one.Part - nearest) / (farthest - nearest) : 0f));
    }

    private List<(int[] Joints, Side Side, int Pair)> FindLimbs(int pelvis)
    {
        var found = new List<(int[] Joints, Side Side, float Away)>();
        for (int i = 0; i < Skeleton.Count; i++)
        {
            if (roles[i] == JointRole.Hip && sides[i] != Side.Median && !Hangs(i, JointRole.Hip))
            {
                int parent = Skeleton.Parents[i];
                float away = pelvis < 0 || parent < 0 ? 0f : Vec.Distance(Skeleton.ModelPositions[pelvis], Skeleton.ModelPositions[i]);
                found.Add((LimbFrom(i), sides[i], away));
            }
        }

        found.Sort((a, b) => a.Away != b.Away ? a.Away.CompareTo(b.Away) : a.Joints[0].CompareTo(b.Joints[0]));
        var pairs = new Dictionary<Side, int>();
        var limbs = new List<(int[] Joints, Side Side, int Pair)>();
        foreach ((int[] joints, Side side, _) in found)
        {
            pairs.TryGetValue(side, out int pair);
            limbs.Add((joints, side, pair));
            pairs[side] = pair + 1;
        }

        return limbs;
    }

    private bool Hangs(int joint, JointRole role)
    {
        for (int above = Skeleton.Parents[joint]; above >= 0; above = Skeleton.Parents[above])
        {
            if (roles[above] == role)
            {
                return true;
            }
        }

        return false;
    }

    private int[] LimbFrom(int hip)
    {
        int[] limb = { hip, -1, -1, -1 };
        int at = hip;
        for (int i = hip + 1; i < Skeleton.Count; i++)
        {
            int place = Array.IndexOf(limbRoles, roles[i]);
            if (place > 0 && limb[place] < 0 && Array.IndexOf(limbRoles, roles[at]) < place && Below(i, at))
            {
                limb[place] = i;
                at = i;
            }
        }

        return limb;
    }

    private bool Below(int joint, int above)
    {
        int at = joint;
        while (at > above)
        {
            at = Skeleton.Parents[at];
        }

        return at == above;
    }
}
