using System;
using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>Gives an appendage its joints, left and right.</summary>
internal static class LimbRigger
{
    private static readonly (JointRole Role, string Name)[] legJoints =
    {
        (JointRole.Girdle, "Girdle"), (JointRole.Hip, "Hip"), (JointRole.Knee, "Knee"), (JointRole.Ankle, "Ankle"), (JointRole.Ball, "Ball"), (JointRole.End, "End"),
    };

    /// <summary>Adds the joints to the skeleton.</summary>
    /// <param name="skeleton">Receives the joints.</param>
    /// <param name="appendage">What to rig.</param>
    /// <param name="parent">Joint in the sagittal plane that carries it.</param>
    public static AppendageJoints Add(SkeletonBuilder skeleton, Appendage appendage, int parent)
    {
        bool leg = appendage.Kind is LimbKind.Leg or LimbKind.Arm;
        int points = appendage.Joints.Length;
        if (points < 2 || (leg && (points != 5 || appendage.Archetype == null)))
        {
            throw new ArgumentException(FormattableString.Invariant($"{appendage.Kind} {appendage.Pair} has {points} joint points; expected 5 and an archetype for legs and arms, at least 2 for others"), nameof(appendage));
        }

        List<JointDefinition> left = leg ? Leg(appendage) : Chain(appendage);
        if (!appendage.Paired)
        {
            int[] joints = new int[left.Count];
            for (int k = 0; k < joints.Length; k++)
            {
                joints[k] = skeleton.Add(k == 0 ? parent : joints[k - 1], Side.Median, left[k]);
            }

            return new AppendageJoints(joints, Array.Empty<int>());
        }

        string[] names = new string[left.Count];
        for (int k = 0; k < names.Length; k++)
        {
            names[k] = NameOf(appendage, Side.Right, SuffixOf(leg, k, names.Length));
        }

        int[] pair = skeleton.AddPair(parent, left, names);
        return new AppendageJoints(pair.AsSpan(0, names.Length).ToArray(), pair.AsSpan(names.Length).ToArray());
    }

    private static List<JointDefinition> Leg(Appendage leg)
    {
        LimbArchetype archetype = leg.Archetype!.Value;
        LegOutline outline = LegKinds.Of(archetype).Outline;
        Vector3 hip = leg.Joints[0];
        Vector3 hinge = outline.Lateral && !leg.Stands ? TrailingHinge(leg) : outline.Lateral ? LateralHinge(leg) : Vec.Normalize(Vec.Reject(Vector3.UnitX, Vec.Normalize(leg.Joints[2] - hip, -Vector3.UnitY)), Vector3.UnitX);

        // The girdle sits half way in from the hip, so that its bone has a direction; it only slides.
        var girdle = new Vector3(hip.X / 2f, hip.Y, hip.Z);
        var joints = new List<JointDefinition>(legJoints.Length)
        {
            Define(0, girdle, JointFrame.Raised(hip - girdle, Vector3.UnitY), hip, JointLimit.Fixed),
        };
        for (int k = 0; k < 4; k++)
        {
            // A sprawler's foot points ahead like any other foot.
            bool foot = outline.Sprawling && k >= 2;
            JointRole role = legJoints[k + 1].Role;
            Quaternion frame = JointFrame.Hinged(leg.Joints[k + 1] - leg.Joints[k], foot ? Vector3.UnitX : hinge);
            joints.Add(Define(k + 1, leg.Joints[k], frame, leg.Joints[k + 1], JointLimits.Leg(archetype, role)));
        }

        joints.Add(new JointDefinition(NameOf(leg, Side.Left, "End"), JointRole.End, leg.Joints[4], joints[4].Rotation, 0f, JointLimit.Fixed));
        return joints;

        JointDefinition Define(int k, Vector3 position, Quaternion rotation, Vector3 child, JointLimit limit) =>
            new(NameOf(leg, Side.Left, legJoints[k].Name), legJoints[k].Role, position, rotation, Vec.Distance(position, child), limit);
    }

    /// <summary>Normal of the plane in which hip, knee and ankle lie, towards the front.</summary>
    private static Vector3 LateralHinge(Appendage leg)
    {
        Vector3 normal = Vec.Cross(leg.Joints[1] - leg.Joints[0], leg.Joints[2] - leg.Joints[0]);
        normal = Vec.Normalize(new Vector3(normal.X, 0f, normal.Z), Vector3.UnitZ);
        return normal.Z < 0f ? -normal : normal;
    }

    /// <summary>The same of a leg laid back along the flank, whose knee bends in a plane that is rather level: the side of it that would be in front if the leg were spread.</summary>
    private static Vector3 TrailingHinge(Appendage leg) =>
        Vec.Normalize(Vec.Cross(leg.Joints[2] - leg.Joints[0], leg.Joints[1] - leg.Joints[0]), -Vector3.UnitY);

    private static List<JointDefinition> Chain(Appendage appendage)
    {
        int last = appendage.Joints.Length - 1;
        JointRole role = appendage.Kind switch
        {
            LimbKind.Wing or LimbKind.InsectWing => JointRole.Wing,
            LimbKind.Ear => JointRole.Ear,
            LimbKind.Antenna or LimbKind.Tail => JointRole.Antenna,
            LimbKind.Pectoral or LimbKind.Dorsal or LimbKind.Ventral or LimbKind.Disc => JointRole.Fin,
            _ => throw new ArgumentOutOfRangeException(nameof(appendage), appendage.Kind, "expected a kind of limb that is a chain"),
        };
        Side side = appendage.Paired ? Side.Left : Side.Median;
        var joints = new List<JointDefinition>(last + 1);
        for (int k = 0; k < last; k++)
        {
            Vector3 direction = appendage.Joints[k + 1] - appendage.Joints[k];
            Quaternion frame = !appendage.Paired ? JointFrame.Median(direction)
                : role is JointRole.Ear ? JointFrame.Raised(direction, appendage.Pole)
                : role is JointRole.Antenna ? JointFrame.Hinged(direction, Vector3.UnitX)
                : JointFrame.Raised(direction, Vector3.UnitY);
            JointLimit limit = appendage.Kind == LimbKind.Wing ? JointLimits.Wing(k) : JointLimits.Soft(role, k);
            joints.Add(new JointDefinition(NameOf(appendage, side, SuffixOf(false, k, last + 1)), role, appendage.Joints[k], frame, Vec.Length(direction), limit));
        }

        joints.Add(new JointDefinition(NameOf(appendage, side, "End"), JointRole.End, appendage.Joints[last], joints[last - 1].Rotation, 0f, JointLimit.Fixed));
        return joints;
    }

    private static string SuffixOf(bool leg, int joint, int count) =>
        leg ? legJoints[joint].Name : joint == count - 1 ? "End" : (joint + 1).ToString(CultureInfo.InvariantCulture);

    /// <summary>Leg_L1_Knee, Wing_R1_2, Dorsal_1_End; the first pair of ears and antennae goes without a number: Ear_L_1.</summary>
    private static string NameOf(Appendage appendage, Side side, string suffix)
    {
        string kind = appendage.Kind switch
        {
            LimbKind.Leg => "Leg",
            LimbKind.Arm => "Arm",
            LimbKind.Wing => "Wing",
            LimbKind.InsectWing => "InsectWing",
            LimbKind.Pectoral => "Fin",
            LimbKind.Dorsal => "Dorsal",
            LimbKind.Ventral => "Ventral",
            LimbKind.Ear => "Ear",
            LimbKind.Antenna => "Antenna",
            LimbKind.Tail => "Tail",
            LimbKind.Disc => "Disc",
            _ => throw new ArgumentOutOfRangeException(nameof(appendage), appendage.Kind, "expected a kind of limb"),
        };
        string letter = side switch { Side.Left => "L", Side.Right => "R", _ => "" };
        bool numbered = !(appendage.Kind is LimbKind.Ear or LimbKind.Antenna) || appendage.Pair > 1;
        return kind + "_" + letter + (numbered ? appendage.Pair.ToString(CultureInfo.InvariantCulture) : "") + "_" + suffix;
    }
}
