using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using CreatureGen.Species;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>A creature that stands on legs, as its walk needs it. Immutable, shared between all its animators.</summary>
internal sealed class LeggedBody
{
    /// <summary>Part of the joints' limits that turns of a neck to a side take up: as much is left for its nods.</summary>
    private const float TurnFraction = 0.7f;

    /// <summary>How far a body rolls with the ground at most, radians.</summary>
    private const float SteepestRoll = 0.5f;

    /// <summary>Share of the way that a hip draws its leg in which the roll of the body takes up: the rest is for its steps.</summary>
    private const float RollFraction = 0.15f;

    /// <summary>Share of the room to the inner end of a standing hip that the sway of the body takes up: the rest is for its roll and its steps.</summary>
    private const float SwayFraction = 0.6f;

    /// <summary>How far a body sways at most whose legs stand out to the side, leg lengths, and part of how far the foot is outside its hip.</summary>
    private const float LateralSway = 0.14f;
    private const float LateralSwayFraction = 0.45f;

    private LeggedBody(MotionSubject subject, LimbChain[] standing)
    {
        Subject = subject;
        Skeleton = subject.Skeleton;
        Mass = Math.Max(subject.Mass.Mass, 1e-4f);
        int[] rows = RowsOf(standing);
        Rows = 1 + rows.Max();
        Trunk = ChainOf(subject.Skeleton, JointRole.Pelvis, JointRole.Spine, JointRole.Chest);
        SoleExtent[] soles = SoleExtent.Measure(subject, standing);
        Legs = new LegRig[standing.Length];
        float hind = 0f;
        float hips = 0f;
        float halfTrack = 0f;
        int rear = 0;
        for (int i = 0; i < standing.Length; i++)
        {
            int parent = Skeleton.Parents[standing[i].Joints[0]];
            Legs[i] = new LegRig(Skeleton, standing[i], rows[i], Math.Max(Array.IndexOf(Trunk, parent), 0), soles[i], subject.Bones);
            halfTrack = Math.Max(halfTrack, Math.Abs(Legs[i].Home.X));
            if (rows[i] == 0)
            {
                hind += Legs[i].Length;
                hips += Legs[i].HipRest.Y;
                rear++;
            }
        }

        GoingHomes = NeutralFootholds.Of(Legs, Rows);
        HindHips = Array.Find(Legs, leg => leg.Row == 0)!.HipRest with { X = 0f };
        ForeHips = Array.Find(Legs, leg => leg.Row == Rows - 1)!.HipRest with { X = 0f };
        StepRanges = new StepRange[Legs.Length];
        WidestSteps = new StepRange[Legs.Length];
        for (int i = 0; i < Legs.Length; i++)
        {
            StepRanges[i] = StepRange.Of(Legs[i], GoingHomes[i], 0f);
            WidestSteps[i] = StepRange.Of(Legs[i], GoingHomes[i], StepRange.Drop);
            FarthestFoot = Math.Max(FarthestFoot, Vec.Length(GoingHomes[i]));
            Middle += Legs[i].Home / Legs.Length;
        }

        LegLength = hind / rear;
        HipHeight = hips / rear;
        HalfTrack = halfTrack;
        ForeSlot = 0;
        foreach (LegRig leg in Legs)
        {
            ForeSlot = Rows > 1 && leg.Row == Rows - 1 ? Math.Max(ForeSlot, leg.TrunkSlot) : ForeSlot;
        }

        if (ForeSlot == 0)
        {
            ForeSlot = Trunk.Length - 1;
        }

        foreach (LegRig leg in Legs)
        {
            HindStoop = leg.IsHind(Rows) ? Math.Max(HindStoop, leg.Stoop) : HindStoop;
            ForeStoop = leg.IsHind(Rows) ? ForeStoop : Math.Max(ForeStoop, leg.Stoop);
        }

        TrunkLength = Vec.Distance(Skeleton.ModelPositions[Trunk[0]], Skeleton.ModelPositions[Trunk[ForeSlot]]);
        Yaw = TrunkYaw.Of(Legs, LegLength, TrunkLength);
        Traits = Yaw.Of(TrunkTraits.Of(subject.Plan, subject.Manner, Mass));
        Posture = StandingPosture.Of(subject);
        Span = TrunkSpan.Of(Legs, GoingHomes, Rows, Skeleton.ModelPositions[Trunk[0]], Skeleton.ModelPositions[Trunk[ForeSlot]], TrunkLength);
        Neck = ChainOf(Skeleton, JointRole.Neck, JointRole.Head);
        NeckLimits = Array.ConvertAll(Neck, joint => TrunkBends.Fraction * Math.Min(-Skeleton.Joints[joint].Limit.SwingX.Min, Skeleton.Joints[joint].Limit.SwingX.Max));
        NeckTurns = Array.ConvertAll(Neck, joint => TurnFraction * NarrowestSwing(Skeleton.Joints[joint].Limit));
        Tail = ChainOf(Skeleton, JointRole.Tail);
        TailLimits = Array.ConvertAll(Tail, joint => NarrowestSwing(Skeleton.Joints[joint].Limit));

        Vector3 chest = Skeleton.ModelPositions[Trunk[Trunk.Length - 1]];
        Vector3 head = Skeleton.ModelPositions[Neck.Length > 0 ? Neck[Neck.Length - 1] : Trunk[Trunk.Length - 1]];
        NeckLength = Math.Max(Vec.Distance(chest, head), 0.05f * LegLength);
        BellyHeight = BellyOf(subject);
        Arms = ArmsOf(subject);
        Body = Skeleton.FirstOf(JointRole.Body);
        MaxRoll = IsBiped ? 0f : MaxRollOf(Legs);
        MaxSway = MaxSwayOf(Legs);
        Bends = new TrunkBends(Skeleton, Trunk, ForeSlot);
        Front = TrunkFront.Of(Legs, Rows, ForeSlot);
        Turns = new RestRotations(Skeleton);
        TrunkRest = Array.ConvertAll(Trunk, joint => Skeleton.ModelPositions[joint]);
        Hops = Rows == 1 && subject.Plan == BodyPlan.Upright && LongFeet() && TailLength() > 0.8f * LegLength;
        Idle = IdleRhythm.Of(Mass);
        Flippers = Waddles && subject.Kind == LocomotionKind.Walking ? FlippersOf(subject) : Array.Empty<LimbChain>();
    }

    public MotionSubject Subject { get; }

    public Skeleton Skeleton { get; }

    /// <summary>Kilograms.</summary>
    public float Mass { get; }

    public LegRig[] Legs { get; }

    /// <summary>Where each foot belongs under a body that goes, model space.</summary>
    public Vector3[] GoingHomes { get; }

    /// <summary>How far each foot can go from there.</summary>
    public StepRange[] StepRanges { get; }

    /// <summary>The same of steps over which the body comes down: in turns steps come quicker first, and then are as wide.</summary>
    public StepRange[] WidestSteps { get; }

    /// <summary>Distance of the farthest of these places from the root, about which the body turns, metres.</summary>
    public float FarthestFoot { get; }

    /// <summary>The middle of where its feet stand at rest, model space.</summary>
    public Vector3 Middle { get; }

    /// <summary>Number of pairs of legs.</summary>
    public int Rows { get; }

    /// <summary>Pelvis, spine, chest.</summary>
    public int[] Trunk { get; }

    /// <summary>Places of the trunk's joints at rest, model space.</summary>
    public Vector3[] TrunkRest { get; }

    /// <summary>The trunk joint that carries the foremost legs, as a place in <see cref="Trunk"/>; of bipeds the chest.</summary>
    public int ForeSlot { get; }

    /// <summary>How far the trunk bends.</summary>
    public TrunkBends Bends { get; }

    /// <summary>What of it acts raise with its feet.</summary>
    public TrunkFront Front { get; }

    /// <summary>How far it rolls with the ground to a side, radians: less on hips that do not draw their legs in far, and not at all on two legs.</summary>
    public float MaxRoll { get; }

    /// <summary>How far it sways to a side at most, metres: what its hips draw their legs in beyond the narrowest track.</summary>
    public float MaxSway { get; }

    /// <summary>How far it sways at most as it turns: the steps of feet ahead of the middle and behind it take hips above them nearer to their ends.</summary>
    /// <param name="turned">In a stance, radians.</param>
    public float MaxSwayIn(float turned) => Legs[0].Lateral ? MaxSway : Math.Max(MaxSway - (0.5f * SwayFraction * Math.Abs(turned) * Math.Max(Math.Abs(ForeHips.Z), Math.Abs(HindHips.Z))), 0f);

    /// <summary>How far the trunk yaws with its feet at most.</summary>
    public TrunkYaw Yaw { get; }

    /// <summary>Neck joints and the head, which is the last.</summary>
    public int[] Neck { get; }

    /// <summary>How far each joint of neck and head nods to its narrower side, radians.</summary>
    public float[] NeckLimits { get; }

    /// <summary>How far each of them turns to a side and has room to nod as well, radians.</summary>
    public float[] NeckTurns { get; }

    public int[] Tail { get; }

    /// <summary>How far each tail joint bends to its narrowest side, radians.</summary>
    public float[] TailLimits { get; }

    /// <summary>Shoulder, elbow and wrist of each arm.</summary>
    public ArmShape[] Arms { get; }

    /// <summary>Writes turns from rest into local poses.</summary>
    public RestRotations Turns { get; }

    /// <summary>The joint that carries the trunk.</summary>
    public int Body { get; }

    public TrunkTraits Traits { get; }

    /// <summary>How it holds its trunk where it stands.</summary>
    public StandingPosture Posture { get; }

    /// <summary>Mean length of the rearmost legs, hip to ground under the ball, metres: the measure of all gaits.</summary>
    public float LegLength { get; }

    public float HipHeight { get; }

    /// <summary>Between the hips of the hindmost and of the foremost pair at rest, model space.</summary>
    public Vector3 HindHips { get; }

    public Vector3 ForeHips { get; }

    /// <summary>How far the rear and the front of the body come down as it goes, metres.</summary>
    public float HindStoop { get; }

    public float ForeStoop { get; }

    public float HalfTrack { get; }

    public float TrunkLength { get; }

    /// <summary>Where the ends of the trunk are over hind and fore feet.</summary>
    public TrunkSpan Span { get; }

    public float NeckLength { get; }

    /// <summary>Lowest point of the trunk at rest, metres above the ground.</summary>
    public float BellyHeight { get; }

    /// <summary>Whether what follows the hips is an abdomen, which does not swing like a tail.</summary>
    public bool HasAbdomen => Subject.Plan is BodyPlan.Hexapod or BodyPlan.Buzzing;

    /// <summary>Whether it is built to hop: upright, with long feet under it and a tail to counter them.</summary>
    public bool Hops { get; }

    /// <summary>Whether its hind legs are built to throw it ahead: those of grasshoppers and frogs.</summary>
    public bool Leaps => Array.Exists(Legs, leg => leg.Row == 0 && leg.Traits.Kind.Step.Leaps);

    /// <summary>Whether it rolls from side to side on short legs under an upright body: penguins.</summary>
    public bool Waddles => IsBiped && Subject.Manner.Waddles;

    /// <summary>The times of what it does while it stands.</summary>
    public IdleRhythm Idle { get; }

    /// <summary>How far a foot pitches, toes down, that rests on its tip while the body stands with its weight on the other one of its pair, radians: the right one of the hindmost of two and more pairs; 0 of all others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float RestPitch(int leg) => Rows > 1 && Legs[leg].Row == 0 && Legs[leg].Side == Side.Right ? Legs[leg].Traits.RestPitch : 0f;

    /// <summary>The share of the usual shift of its weight that it makes as it stands, 0..1: found once, before the body is in use.</summary>
    public float ShiftWeight { get; set; } = 1f;

    /// <summary>Wings that it holds away from its body as it waddles.</summary>
    public LimbChain[] Flippers { get; }

    public bool IsBiped => Rows == 1;

    /// <summary>Whether its rearmost legs stand out to the side.</summary>
    public bool Sprawls => Legs[0].Lateral;

    /// <summary>Whether its rear and its front rise and sink with the legs under each: quadrupeds, and whatever trots and gallops on more legs under it.</summary>
    public bool RidesOnGirdles => Rows == 2 || (Rows > 2 && !Sprawls);

    /// <summary>The legged body of a creature, or null when it stands on nothing.</summary>
    public static LeggedBody? Of(MotionSubject subject)
    {
        var standing = new List<LimbChain>();
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind == LimbKind.Leg && limb.Stands && limb.Archetype != null && limb.Joints.Count == 6)
            {
                standing.Add(limb);
            }
        }

        return standing.Count == 0 ? null : new LeggedBody(subject, standing.ToArray());
    }

    /// <summary>Rows from the rear by the number of the pair.</summary>
    private static int[] RowsOf(LimbChain[] legs)
    {
        List<int> pairs = legs.Select(leg => leg.Pair).Distinct().OrderBy(pair => pair).ToList();
        var rows = new int[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            rows[i] = pairs.Count - 1 - pairs.IndexOf(legs[i].Pair);
        }

        return rows;
    }

    private static LimbChain[] FlippersOf(MotionSubject subject)
    {
        var flippers = new List<LimbChain>();
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind == LimbKind.Wing)
            {
                flippers.Add(limb);
            }
        }

        return flippers.ToArray();
    }

    private static float MaxRollOf(LegRig[] legs)
    {
        float max = SteepestRoll;
        foreach (LegRig leg in legs)
        {
            max = leg.Lateral ? max : Math.Min(max, RollFraction * leg.Limits.DrawsIn);
        }

        return max;
    }

    private static float MaxSwayOf(LegRig[] legs)
    {
        float max = float.MaxValue;
        foreach (LegRig leg in legs)
        {
            float outside = Math.Abs(leg.Home.X - leg.HipRest.X);
            float room = (leg.HipRest.Y * (float)PortableMath.Sin(leg.Limits.DrawsIn)) - ((1f - leg.MinTrack) * Math.Abs(leg.Home.X));
            max = Math.Min(max, leg.Lateral ? Math.Min(LateralSway * leg.Length, LateralSwayFraction * outside) : SwayFraction * Math.Max(room, 0f));
        }

        return max;
    }

    /// <summary>How far a joint swings to its narrowest side, radians.</summary>
    private static float NarrowestSwing(JointLimit limit) => Math.Min(Math.Min(-limit.SwingX.Min, limit.SwingX.Max), Math.Min(-limit.SwingZ.Min, limit.SwingZ.Max));

    /// <summary>The joints of some roles, in the skeleton's order.</summary>
    private static int[] ChainOf(Skeleton skeleton, params JointRole[] roles)
    {
        var chain = new List<int>();
        for (int i = 0; i < skeleton.Count; i++)
        {
            if (Array.IndexOf(roles, skeleton.Joints[i].Role) >= 0 && !Heads.IsFurther(skeleton, i))
            {
                chain.Add(i);
            }
        }

        return chain.ToArray();
    }

    private static ArmShape[] ArmsOf(MotionSubject subject)
    {
        var arms = new List<ArmShape>();
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind == LimbKind.Arm && limb.Joints.Count == 6)
            {
                arms.Add(new ArmShape(limb.Joints[1], limb.Joints[2], limb.Joints[3], limb.Side));
            }
        }

        return arms.ToArray();
    }

    private bool LongFeet() => Vec.Length(Legs[0].Metatarsus) + Legs[0].Toe > 0.42f * LegLength;

    private float TailLength()
    {
        float length = 0f;
        foreach (int joint in Tail)
        {
            length += Skeleton.Joints[joint].Length;
        }

        return length;
    }

    private float BellyOf(MotionSubject subject)
    {
        float rear = Skeleton.ModelPositions[Trunk[0]].Z - (0.2f * LegLength);
        float front = Skeleton.ModelPositions[Trunk[ForeSlot]].Z + (0.2f * LegLength);
        bool[] trunk = new bool[Skeleton.Count];
        foreach (int joint in Trunk)
        {
            trunk[joint] = true;
        }

        float lowest = HipHeight;
        ReadOnlySpan<Vector3> positions = subject.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            if (trunk[subject.Mesh.Weights[v].Joint0] && positions[v].Z > rear && positions[v].Z < front)
            {
                lowest = Math.Min(lowest, positions[v].Y);
            }
        }

        return Math.Max(lowest, 0f);
    }
}
