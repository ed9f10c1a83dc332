using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>What follows from a creature's build for how it falls, lies and gets up: worked out when it is first needed, immutable, shared by all its animators.</summary>
internal sealed class FallProfile
{
    /// <summary>Depth of a landing over v/ω at the damping that landings have, and part of the depth of a crouch that it takes up at most.</summary>
    public const float DepthOfLanding = 0.424f;
    public const float DeepestLanding = 0.95f;

    /// <summary>Speed of a fall that all legs take up, √(gℓ).</summary>
    private const float MinBorne = 1.2f;

    /// <summary>Step in which the depth of its crouch is looked for, leg lengths, how deep that is at most, and what legs give in any case.</summary>
    private const float CrouchStep = 0.02f;
    private const float MaxCrouch = 0.7f;
    private const float MinCrouch = 0.06f;

    /// <summary>How far a foot may be from its place in a crouch, and its skin in the ground, leg lengths.</summary>
    private const float MaxMiss = 0.025f;
    private const float MaxSunk = 0.02f;

    /// <summary>Part of a step by which the body has to come down in it: folded legs let it down no farther.</summary>
    private const float MinGain = 0.5f;

    /// <summary>How hard legs of an animal of the usual mass brake a fall, 1/τ with τ = √(ℓ/g); larger ones take less: their legs grow with the second power of their size, their weight with the third.</summary>
    private const float HardestBraking = 3.2f;
    private const float UsualMass = 30f;
    private const double BrakingPower = -0.08;
    private const float MinFraction = 0.5f;
    private const float GreatestFraction = 1.2f;

    /// <summary>Length by which the times of bodies without legs go, part of their size.</summary>
    private const float BodyHeight = 0.25f;

    private static readonly TimeWindow head = new(0f, 0.45f);
    private static readonly TimeWindow limbs = new(0f, 0.5f);
    private static readonly TimeWindow wings = new(0.25f, 0.9f);
    private static readonly TimeWindow rest = new(0.1f, 0.9f);

    private readonly Lazy<LyingManner?> lying;
    private readonly int[] trunk;

    private FallProfile(MotionSubject subject, LeggedBody? legs, GaitSet? gaits, Func<LyingManner?> lies)
    {
        Skeleton = subject.Skeleton;
        Legs = LyingLeg.Of(legs);
        Topple = ToppleManner.Of(Legs, subject.Seed);
        bool topples = Topple.Topples;
        Ragdoll = Legs.Length > 0 ? new RagdollRig(subject.Skeleton, subject.Bones, PassiveLimit.Of(subject.Skeleton, Legs.Length)) : new RagdollRig(subject.Skeleton, subject.Bones);
        Tone = LimpTone.Of(Ragdoll, topples || (legs != null && subject.Skeleton.FirstOf(JointRole.Wing) >= 0), topples);
        Manner = RisingManner.Of(subject);
        Mass = Math.Max(subject.Mass.Mass, 1e-4f);
        Swims = subject.Kind == LocomotionKind.Swimming;
        Windows = WindowsOf(subject.Skeleton);
        Neck = JointsOf(subject.Skeleton, role => role is JointRole.Neck or JointRole.Head);
        Tail = JointsOf(subject.Skeleton, role => role == JointRole.Tail);
        trunk = JointsOf(subject.Skeleton, role => role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest);
        Overlaid = JointsOf(subject.Skeleton, role => role is JointRole.Neck or JointRole.Head or JointRole.Jaw or JointRole.Eye or JointRole.Antenna or JointRole.Tail);
        Limbs = LyingLimb.Of(subject, Legs);
        lying = new Lazy<LyingManner?>(() => legs == null || Array.Exists(legs.Legs, leg => leg.Lateral) ? null : lies());
        Inertias = HangingInertia.Of(subject.Skeleton, Ragdoll, Mass, legs == null ? ReadOnlySpan<int>.Empty : Array.ConvertAll(legs.Legs, leg => leg.End));
        Height = legs?.LegLength ?? BodyHeight * Ragdoll.Size;
        Body = Math.Max(subject.Skeleton.FirstOf(JointRole.Body), 0);
        Support = SupportPoints.Of(subject);
        if (legs != null)
        {
            CrouchDepth = DepthOf(legs, gaits!, Support);
            float braking = HardestBraking * (float)Scalar.Clamp(PortableMath.Pow(legs.Mass / UsualMass, BrakingPower), MinFraction, GreatestFraction);
            BorneSpeed = Math.Max(MinBorne, DeepestLanding * CrouchDepth / legs.LegLength * braking / DepthOfLanding);
        }
    }

    /// <summary>Its joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>Its parts when it is limp.</summary>
    public RagdollRig Ragdoll { get; }

    /// <summary>How its muscles let go.</summary>
    public LimpTone Tone { get; }

    /// <summary>How it rolls onto its flank, on legs under the body, to another side with each seed.</summary>
    public ToppleManner Topple { get; }

    /// <summary>How it gets up.</summary>
    public RisingManner Manner { get; }

    /// <summary>Kilograms.</summary>
    public float Mass { get; }

    /// <summary>Whether water carries it.</summary>
    public bool Swims { get; }

    /// <summary>When each joint moves as it gathers itself: the head first, the legs before the body rolls over them, the wings as it rolls off them, then the rest.</summary>
    public TimeWindow[] Windows { get; }

    /// <summary>For each joint how much what hangs on it resists turning, kg m²; 0 where it does not give to a blow.</summary>
    public float[] Inertias { get; }

    /// <summary>How high the middle of the trunk of a pose in model space is, metres.</summary>
    public float TrunkHeight(in Pose model)
    {
        float sum = 0f;
        foreach (int joint in trunk)
        {
            sum += model.Positions[joint].Y;
        }

        return sum / Math.Max(trunk.Length, 1);
    }

    /// <summary>Joints of neck and head.</summary>
    public int[] Neck { get; }

    /// <summary>Joints of the tail.</summary>
    public int[] Tail { get; }

    /// <summary>Joints that gaze, acts and springs turn after its way of moving has posed them; ears and lids, which go on to be moved as it lies, are not among them.</summary>
    public int[] Overlaid { get; }

    /// <summary>Its legs.</summary>
    public LyingLeg[] Legs { get; }

    /// <summary>What gives way to the ground as it gathers itself: legs, arms and wings.</summary>
    public LyingLimb[] Limbs { get; }

    /// <summary>How it lies on its belly; null for what has no legs, or any out to the side, and where it cannot. Worked out when it is first asked for, which takes some ten milliseconds.</summary>
    public LyingManner? Lying => lying.Value;

    /// <summary>Length by which its times go, metres: of its legs, or part of its size.</summary>
    public float Height { get; }

    /// <summary>The joint that carries the body.</summary>
    public int Body { get; }

    /// <summary>What it can lie on.</summary>
    public SupportPoints Support { get; }

    /// <summary>How far the body can be let down into its legs with its feet where they belong, metres of the model; 0 without legs.</summary>
    public float CrouchDepth { get; }

    /// <summary>Speed of a fall that its legs take up, √(gℓ).</summary>
    public float BorneSpeed { get; }

    /// <summary>Raises the whole of a pose.</summary>
    /// <param name="local">In the parents' space.</param>
    /// <param name="height">Metres of the model.</param>
    public void Raise(in Pose local, float height)
    {
        int parent = Skeleton.Parents[Body];
        var way = new Vector3(0f, height, 0f);
        local.Positions[Body] += parent < 0 ? way : Rotation.Rotate(Rotation.Inverse(Skeleton.ModelRotations[parent]), way);
    }

    /// <summary>Works it out.</summary>
    /// <param name="subject">Whose.</param>
    /// <param name="legs">The body as its walk sees it; null without legs.</param>
    /// <param name="gaits">How it goes; null without legs.</param>
    /// <param name="lies">Finds how it lies on its belly; null where it cannot.</param>
    public static FallProfile Of(MotionSubject subject, LeggedBody? legs, GaitSet? gaits, Func<LyingManner?> lies) => new(subject, legs, gaits, lies);

    private static int[] JointsOf(Skeleton skeleton, Predicate<JointRole> has)
    {
        var joints = new List<int>();
        for (int j = 0; j < skeleton.Count; j++)
        {
            if (has(skeleton.Joints[j].Role))
            {
                joints.Add(j);
            }
        }

        return joints.ToArray();
    }

    private static TimeWindow[] WindowsOf(Skeleton skeleton)
    {
        var windows = new TimeWindow[skeleton.Count];
        for (int j = 0; j < windows.Length; j++)
        {
            JointRole role = skeleton.Joints[j].Role;
            int parent = skeleton.Parents[j];
            windows[j] = role is JointRole.Neck or JointRole.Head ? head
                : role is JointRole.Girdle or JointRole.Hip or JointRole.Fin ? limbs
                : role == JointRole.Wing ? wings
                : role is JointRole.Knee or JointRole.Ankle or JointRole.Ball or JointRole.End or JointRole.Jaw or JointRole.Ear or JointRole.Antenna && parent >= 0 ? windows[parent]
                : rest;
        }

        return windows;
    }

    /// <summary>The deepest crouch that brings the body down, keeps the feet in their places and the skin out of the ground.</summary>
    private static float DepthOf(LeggedBody body, GaitSet gaits, SupportPoints support)
    {
        var legs = new WalkingMode(body, gaits, new EventQueue(0));
        var pose = new PoseBuffer(body.Skeleton);
        MotionSettings settings = MotionSettings.Default;
        settings.Idle = 0f;
        pose.Clear();
        legs.Stand(RootPlace.Identity, settings, FlatGround.Level, null, pose.Local);
        pose.Finish();
        float start = support.Lowest(pose.Model);
        Vector3[] stands = Array.ConvertAll(body.Legs, leg => pose.Model.Positions[leg.Ball]);
        float height = pose.Model.Positions[body.Trunk[0]].Y;
        float depth = 0f;
        for (int i = 1; i * CrouchStep <= MaxCrouch; i++)
        {
            legs.Sink = i * CrouchStep * body.LegLength;
            pose.Clear();
            legs.Hold(RootPlace.Identity, 0f, settings, null, pose.Local);
            pose.Finish();
            float miss = 0f;
            for (int foot = 0; foot < legs.FootCount; foot++)
            {
                int ball = body.Legs[foot].Ball;
                miss = Math.Max(miss, Vec.Distance(pose.Model.Positions[ball], stands[foot]));
            }

            float now = pose.Model.Positions[body.Trunk[0]].Y;
            float sunk = start - support.Lowest(pose.Model);
            if (miss > MaxMiss * body.LegLength || sunk > MaxSunk * body.LegLength || height - now < MinGain * CrouchStep * body.LegLength)
            {
                break;
            }

            height = now;
            depth = legs.Sink;
        }

        return Math.Max(depth, MinCrouch * body.LegLength);
    }
}
