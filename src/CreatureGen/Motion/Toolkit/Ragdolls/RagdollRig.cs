using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ragdolls;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A creature as rigid parts that hang together at its joints. Immutable.</summary>
/// <remarks>
/// Every joint that holds skin and can turn makes a part, with mass and inertia of its capsule; eyes, jaws, ears, feelers and fins are one with what carries them. No part is lighter than
/// 1/250 of the whole or 1/8 of a part that hangs on it: a light neck under a heavy head is pulled apart in a fall. All resist turning as much as an ellipsoid that reaches 1.2 times as far as their farthest joint: with a joint far out on a part that is easily turned, positions would take many rounds
/// to solve, and nobody sees the difference.
/// </remarks>
public sealed class RagdollRig
{
    private const float MinMassFraction = 0.004f;
    private const float MinFractionOfNext = 0.125f;
    private const float MinStoutness = 0.35f;
    private const float MinArmFraction = 1.2f;
    private readonly RagdollPart[] parts;
    private readonly RagdollContact[] contacts;
    private readonly RagdollBone[] bones;
    private readonly RagdollPair[] pairs;
    private readonly int[] partOfJoint;

    /// <summary>Takes a skeleton and its capsules.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="capsules">In the space of its joints, model metres.</param>
    /// <exception cref="ArgumentException">There is no capsule.</exception>
    public RagdollRig(Skeleton skeleton, IReadOnlyList<CapsuleCollider> capsules)
        : this(skeleton, capsules, joint => joint.Limit)
    {
    }

    /// <summary>Takes a skeleton, its capsules, and how far its joints go.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="capsules">In the space of its joints, model metres.</param>
    /// <param name="limitOf">Limit of a joint without muscles, within its own.</param>
    /// <exception cref="ArgumentException">There is no capsule.</exception>
    internal RagdollRig(Skeleton skeleton, IReadOnlyList<CapsuleCollider> capsules, Func<Joint, JointLimit> limitOf)
    {
        if (capsules.Count == 0)
        {
            throw new ArgumentException("no capsule; expected one for each bone that holds skin", nameof(capsules));
        }

        Skeleton = skeleton;
        partOfJoint = new int[skeleton.Count];
        List<int> owners = Owners(skeleton, capsules, partOfJoint);
        var masses = new PartMass[owners.Count];
        foreach (CapsuleCollider capsule in capsules)
        {
            masses[partOfJoint[capsule.Joint]].Add(InOwner(capsule, owners));
        }

        float total = 0f;
        foreach (PartMass mass in masses)
        {
            total += mass.Volume;
        }

        parts = new RagdollPart[owners.Count];
        int[] above = new int[parts.Length];
        float[] fractions = new float[parts.Length];
        for (int i = parts.Length - 1; i >= 0; i--)
        {
            above[i] = i == 0 ? -1 : partOfJoint[skeleton.Parents[owners[i]]];
            fractions[i] = Math.Max(Math.Max(masses[i].Volume / total, MinMassFraction), fractions[i]);
            if (i > 0)
            {
                fractions[above[i]] = Math.Max(fractions[above[i]], MinFractionOfNext * fractions[i]);
            }
        }

        for (int i = 0; i < parts.Length; i++)
        {
            parts[i] = Part(skeleton, owners, masses, i, above[i], fractions[i], limitOf);
        }

        var balls = new List<RagdollContact>();
        foreach (CapsuleCollider capsule in capsules)
        {
            int part = partOfJoint[capsule.Joint];
            CapsuleCollider own = InOwner(capsule, owners);
            balls.Add(new RagdollContact(part, own.Start - parts[part].Centre, own.Radius));
            if (Vec.Distance(own.Start, own.End) > 0.1f * own.Radius)
            {
                balls.Add(new RagdollContact(part, own.End - parts[part].Centre, own.Radius));
            }
        }

        contacts = balls.ToArray();
        bones = BonesOf(capsules, owners);
        pairs = RagdollCollision.PairsOf(
            parts,
            bones,
            Array.ConvertAll(parts, part => skeleton.ModelPositions[part.Joint] + Rotation.Rotate(skeleton.ModelRotations[part.Joint], part.Centre)),
            Array.ConvertAll(parts, part => skeleton.ModelRotations[part.Joint]));
        Size = SizeOf(skeleton);
    }

    /// <summary>Of these joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>Number of rigid parts.</summary>
    public int Count => parts.Length;

    /// <summary>Largest distance between joints and the first part's joint, model metres.</summary>
    public float Size { get; }

    /// <summary>The joint of the first part, on which all others hang.</summary>
    public int FirstJoint => parts[0].Joint;

    /// <summary>Mass of the part that a joint belongs to, share of the whole.</summary>
    /// <param name="joint">Skeleton index.</param>
    internal float MassOf(int joint) => 1f / parts[partOfJoint[joint]].InverseMass;

    /// <summary>The parts, parents first.</summary>
    internal ReadOnlySpan<RagdollPart> Parts => parts;

    /// <summary>What touches the ground.</summary>
    internal ReadOnlySpan<RagdollContact> Contacts => contacts;

    /// <summary>What of each part touches others.</summary>
    internal ReadOnlySpan<RagdollBone> Bones => bones;

    /// <summary>The parts that may meet.</summary>
    internal ReadOnlySpan<RagdollPair> Pairs => pairs;

    /// <summary>The part that each joint belongs to; 0 for those above the first part.</summary>
    internal ReadOnlySpan<int> PartOfJoint => partOfJoint;

    /// <summary>The joints that make parts, parents first: the creature's body, then what hangs on it.</summary>
    private static List<int> Owners(Skeleton skeleton, IReadOnlyList<CapsuleCollider> capsules, int[] partOfJoint)
    {
        bool[] solid = new bool[skeleton.Count];
        foreach (CapsuleCollider capsule in capsules)
        {
            solid[capsule.Joint] = true;
        }

        int body = skeleton.Count > 1 && skeleton.Joints[0].Role == JointRole.Root ? 1 : 0;
        var owners = new List<int> { body };
        bool firstIsSolid = solid[body];
        for (int i = body + 1; i < skeleton.Count; i++)
        {
            Joint joint = skeleton.Joints[i];
            int parent = Math.Max(joint.Parent, body);
            bool turns = joint.Limit != JointLimit.Fixed && joint.Role is not (JointRole.End or JointRole.Girdle or JointRole.Eye or JointRole.Lid or JointRole.Jaw or JointRole.Ear or JointRole.Antenna or JointRole.Fin);
            if (turns && solid[i] && !firstIsSolid)
            {
                // A body joint without skin of its own is one with the first that has some.
                firstIsSolid = true;
                partOfJoint[i] = 0;
            }
            else if (turns && solid[i])
            {
                partOfJoint[i] = owners.Count;
                owners.Add(i);
            }
            else
            {
                partOfJoint[i] = partOfJoint[parent];
            }
        }

        return owners;
    }

    private static float SizeOf(Skeleton skeleton)
    {
        float size = 0f;
        Vector3 middle = skeleton.ModelPositions[Math.Min(1, skeleton.Count - 1)];
        foreach (Vector3 p in skeleton.ModelPositions)
        {
            size = Math.Max(size, Vec.Distance(p, middle));
        }

        return size;
    }

    private RagdollPart Part(Skeleton skeleton, List<int> owners, PartMass[] masses, int i, int parent, float mass, Func<Joint, JointLimit> limitOf)
    {
        int joint = owners[i];
        Vector3 centre = masses[i].Centre;
        Vector3 inertia = masses[i].Inertia(MinStoutness, mass, MinArmFraction * Arm(skeleton, owners, centre, i));
        if (parent < 0)
        {
            return new RagdollPart(joint, -1, centre, mass, inertia, Vector3.Zero, Quaternion.Identity, JointLimit.Free);
        }

        int above = owners[parent];
        Quaternion toParent = Rotation.Inverse(skeleton.ModelRotations[above]);
        Vector3 pivot = Rotation.Rotate(toParent, skeleton.ModelPositions[joint] - skeleton.ModelPositions[above]) - masses[parent].Centre;
        Quaternion rest = Rotation.Normalize(Rotation.Multiply(toParent, skeleton.ModelRotations[joint]));
        return new RagdollPart(joint, parent, centre, mass, inertia, pivot, rest, limitOf(skeleton.Joints[joint]));
    }

    /// <summary>The longest way from a part's centre of mass to a joint on it.</summary>
    private float Arm(Skeleton skeleton, List<int> owners, Vector3 centre, int part)
    {
        int own = owners[part];
        Quaternion toOwn = Rotation.Inverse(skeleton.ModelRotations[own]);
        float arm = Vec.Length(centre);
        for (int k = part + 1; k < owners.Count; k++)
        {
            if (partOfJoint[skeleton.Parents[owners[k]]] == part)
            {
                Vector3 pivot = Rotation.Rotate(toOwn, skeleton.ModelPositions[owners[k]] - skeleton.ModelPositions[own]);
                arm = Math.Max(arm, Vec.Distance(pivot, centre));
            }
        }

        return arm;
    }

    /// <summary>The thickest capsule of each part; wings and fins, which fold flat, touch nothing.</summary>
    private RagdollBone[] BonesOf(IReadOnlyList<CapsuleCollider> capsules, List<int> owners)
    {
        var found = new RagdollBone[parts.Length];
        foreach (CapsuleCollider capsule in capsules)
        {
            int part = partOfJoint[capsule.Joint];
            CapsuleCollider own = InOwner(capsule, owners);
            if (capsule.Radius > found[part].Radius && Skeleton.Joints[owners[part]].Role is not (JointRole.Wing or JointRole.Fin))
            {
                found[part] = new RagdollBone(own.Start - parts[part].Centre, own.End - parts[part].Centre, own.Radius);
            }
        }

        return found;
    }

    /// <summary>A capsule in the axes of the joint that owns its part.</summary>
    private CapsuleCollider InOwner(CapsuleCollider capsule, List<int> owners)
    {
        int owner = owners[partOfJoint[capsule.Joint]];
        Quaternion toOwner = Rotation.Inverse(Skeleton.ModelRotations[owner]);
        Quaternion turn = Rotation.Multiply(toOwner, Skeleton.ModelRotations[capsule.Joint]);
        Vector3 shift = Rotation.Rotate(toOwner, Skeleton.ModelPositions[capsule.Joint] - Skeleton.ModelPositions[owner]);
        return new CapsuleCollider(owner, shift + Rotation.Rotate(turn, capsule.Start), shift + Rotation.Rotate(turn, capsule.End), capsule.Radius);
    }
}
