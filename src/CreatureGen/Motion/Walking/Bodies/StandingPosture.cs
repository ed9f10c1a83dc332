using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>How a flier on two legs holds its trunk where it stands: raised, while it flies level. Its feet stay under its centre of mass, its head level, and its tail off the ground. All else stands as it is built.</summary>
internal sealed class StandingPosture
{
    /// <summary>Part of the limit of a tail's joint that its posture uses; the rest is for its swing.</summary>
    public const float TailFraction = 0.4f;

    /// <summary>Part of the turn of its trunk that a tail takes back, where it is clear of the ground so.</summary>
    private const double TailFollows = 0.5;

    private const double TailRises = 1.3;
    private const double TailStep = 0.1;

    /// <summary>Parts of it that are given up at a walk, and at a run on top.</summary>
    private const float LoweredToWalk = 0.4f;
    private const float LoweredToRun = 0.4f;

    /// <summary>Part of what is left that is given up in a crouch, and how deep that is, leg lengths.</summary>
    private const float LoweredToCrouch = 0.7f;
    private const float DeepCrouch = 0.3f;

    /// <summary>Height of the hips above which a tail is clear of the ground.</summary>
    private const double TailClearance = 0.12;

    /// <summary>Half the height of a tail relative to the capsules of its bones: fans are flat.</summary>
    private const double TailThickness = 0.3;

    /// <summary>Most that a trunk is raised, radians, and by how much less at a time where its tail would touch the ground.</summary>
    private const double MaxRaised = 0.75;
    private const double RaiseStep = 0.05;

    /// <summary>Part of what a neck's joint can nod that keeps the head level; the rest is for looking down.</summary>
    private const float NodFraction = 0.7f;

    private static readonly StandingPosture asBuilt = new(0, 0, TailFollows, Array.Empty<float>());

    private readonly float[] nods;

    private StandingPosture(double raised, double ahead, double tailSteadiness, float[] nods)
    {
        Raised = (float)raised;
        Ahead = (float)ahead;
        TailSteadiness = (float)tailSteadiness;
        this.nods = nods;
    }

    /// <summary>How far the trunk is raised from how it is built, radians, turning about the pelvis.</summary>
    public float Raised { get; }

    /// <summary>How far the pelvis goes ahead for it, metres.</summary>
    public float Ahead { get; }

    /// <summary>Part of the turn of the trunk that the tail takes back.</summary>
    public float TailSteadiness { get; }

    /// <summary>How far a joint of the neck, or the head, nods to keep the head level, radians; the joints are counted from the chest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Nod(int joint) => joint < nods.Length ? nods[joint] : 0f;

    /// <summary>The posture of a creature.</summary>
    public static StandingPosture Of(MotionSubject subject)
    {
        int legs = 0;
        foreach (LimbChain limb in subject.Limbs)
        {
            legs += limb.Kind == LimbKind.Leg && limb.Stands ? 1 : 0;
        }

        return subject.Plan == BodyPlan.Flapping && legs == 2 ? new CarriedBody(subject).Stand(Scalar.Radians(subject.Manner.StandingPitch)) : asBuilt;
    }

    /// <summary>How much of the posture it keeps, 0..1: it comes down to walk, farther to run, and to crouch.</summary>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="froude">v²/(gℓ).</param>
    /// <param name="sunk">How far the body is let down into its legs, leg lengths.</param>
    public static float Fraction(float activity, float froude, float sunk) =>
        (1f - (LoweredToWalk * Scalar.Smooth(activity)) - (LoweredToRun * Scalar.Smooth(froude))) * (1f - (LoweredToCrouch * Scalar.Smooth(sunk / DeepCrouch)));

    /// <summary>What is weighed: trunk, neck with head, and tail, as capsules. Wings weigh little, and legs stay.</summary>
    private sealed class CarriedBody
    {
        private readonly MotionSubject subject;
        private readonly Skeleton skeleton;
        private readonly JointRole[] parts;
        private readonly Vector3 pelvis;
        private readonly Vector3 neck;
        private readonly Vector3 tail;
        private readonly int tailBones;

        public CarriedBody(MotionSubject subject)
        {
            this.subject = subject;
            skeleton = subject.Skeleton;
            parts = new JointRole[skeleton.Count];
            for (int i = 0; i < parts.Length; i++)
            {
                JointRole role = skeleton.Joints[i].Role;
                tailBones += role == JointRole.Tail ? 1 : 0;
                int parent = skeleton.Parents[i];
                parts[i] = role is JointRole.Neck or JointRole.Tail or JointRole.Wing or JointRole.Girdle ? role : parent < 0 ? JointRole.Body : parts[parent];
            }

            pelvis = First(JointRole.Pelvis);
            neck = First(JointRole.Neck);
            tail = First(JointRole.Tail);
        }

        public StandingPosture Stand(double wanted)
        {
            Vector3 back = First(JointRole.Chest) - pelvis;
            double raised = Scalar.Clamp(wanted - PortableMath.Atan2(back.Y, back.Z), 0, MaxRaised);
            double min = Math.Min(Lowest(0, 0), TailClearance * pelvis.Y);
            double steadiness = TailFollows;
            for (; Lowest(raised, steadiness) < min; steadiness += TailStep)
            {
                if (steadiness > TailRises)
                {
                    if (raised <= 0)
                    {
                        return asBuilt;
                    }

                    raised = Math.Max(0, raised - RaiseStep);
                    steadiness = TailFollows;
                }
            }

            return new StandingPosture(raised, Ahead(raised, steadiness), steadiness, Nods((float)raised));
        }

        /// <summary>The joints of the neck share the nod alike, as far as each of them can.</summary>
        private float[] Nods(float raised)
        {
            var room = new List<float>();
            for (int j = 0; j < skeleton.Count; j++)
            {
                Joint joint = skeleton.Joints[j];
                if (joint.Role is JointRole.Neck or JointRole.Head && !Heads.IsFurther(skeleton, j))
                {
                    room.Add(NodFraction * joint.Limit.SwingX.Max);
                }
            }

            var nods = new float[room.Count];
            for (int round = 0; round < nods.Length; round++)
            {
                float left = raised;
                int free = 0;
                for (int i = 0; i < nods.Length; i++)
                {
                    left -= nods[i];
                    free += nods[i] < room[i] ? 1 : 0;
                }

                for (int i = 0; i < nods.Length && free > 0; i++)
                {
                    nods[i] = Math.Min(room[i], nods[i] < room[i] ? nods[i] + (left / free) : nods[i]);
                }
            }

            return nods;
        }

        /// <summary>Where a point of a part goes as the trunk is raised.</summary>
        private Vector3 Moved(Vector3 point, JointRole part, double raised, double steadiness)
        {
            Quaternion turn = AxisRotation.Pitch(-raised);
            return part switch
            {
                JointRole.Neck => Turned(neck, turn) + point - neck,
                JointRole.Tail => Turned(tail, turn) + Rotation.Rotate(AxisRotation.Pitch(-raised * (1 - steadiness)), point - tail),
                _ => Turned(point, turn),
            };
        }

        private Vector3 Turned(Vector3 point, Quaternion turn) => pelvis + Rotation.Rotate(turn, point - pelvis);

        /// <summary>Height of the lowest point of the tail, whose joints share what it takes back.</summary>
        private double Lowest(double raised, double steadiness)
        {
            double lowest = double.MaxValue;
            double turned = -raised;
            Vector3 place = Turned(tail, AxisRotation.Pitch(-raised));
            foreach (CapsuleCollider bone in subject.Bones)
            {
                if (skeleton.Joints[bone.Joint].Role == JointRole.Tail)
                {
                    JointLimit limit = skeleton.Joints[bone.Joint].Limit;
                    double max = TailFraction * Math.Min(Math.Min(-limit.SwingX.Min, limit.SwingX.Max), Math.Min(-limit.SwingZ.Min, limit.SwingZ.Max));
                    turned += Math.Min(steadiness * raised / tailBones, max);
                    Vector3 along = Rotation.Rotate(skeleton.ModelRotations[bone.Joint], new Vector3(0f, skeleton.Joints[bone.Joint].Length, 0f));
                    place += Rotation.Rotate(AxisRotation.Pitch(turned), along);
                    lowest = Math.Min(lowest, place.Y - (TailThickness * bone.Radius));
                }
            }

            return lowest;
        }

        private double Ahead(double raised, double steadiness)
        {
            double moment = 0;
            double mass = 0;
            foreach (CapsuleCollider bone in subject.Bones)
            {
                JointRole part = parts[bone.Joint];
                if (part is JointRole.Body or JointRole.Neck or JointRole.Tail)
                {
                    Vector3 middle = skeleton.ModelPositions[bone.Joint] + Rotation.Rotate(skeleton.ModelRotations[bone.Joint], (bone.Start + bone.End) * 0.5f);
                    double volume = bone.Radius * bone.Radius * (Vec.Distance(bone.Start, bone.End) + (4.0 / 3 * bone.Radius));
                    moment += volume * (middle.Z - Moved(middle, part, raised, steadiness).Z);
                    mass += volume;
                }
            }

            return mass > 0 ? moment / mass : 0;
        }

        private Vector3 First(JointRole role) => skeleton.FirstOf(role) is >= 0 and int joint ? skeleton.ModelPositions[joint] : pelvis;
    }
}
