using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>A creature's body as acts see it: its parts by what they are for, and its units. Immutable.</summary>
internal sealed class ActBody
{
    /// <summary>Leg lengths in the length of a body without legs.</summary>
    private const float LegsPerBody = 6f;

    /// <summary>Part of a crawler's trunk, from the head, that rises with its neck.</summary>
    private const float RisingFraction = 0.45f;

    /// <summary>Part of an abdomen, from the trunk, that stays as it is.</summary>
    private const float StiffFraction = 0.34f;

    /// <summary>Length of a tail that sweeps, parts of the trunk's.</summary>
    private const float LongTailFraction = 0.5f;

    /// <summary>How far the chest goes ahead of the fore legs' hips and behind them, leg lengths.</summary>
    private const float ChestLength = 0.3f;

    public ActBody(MotionSubject subject, LeggedBody? legs)
    {
        Subject = subject;
        Skeleton = subject.Skeleton;
        Legs = legs;
        Turns = legs?.Turns ?? new RestRotations(Skeleton);
        Build = BuildOf(subject, legs);
        Body = Skeleton.FirstOf(JointRole.Body);
        Spine = Joints(JointRole.Spine, JointRole.Chest);
        Head = Skeleton.FirstOf(JointRole.Head);
        Jaw = Skeleton.FirstOf(JointRole.Jaw);
        Bearers = BearersOf();
        Neck = new TurnedChain(Skeleton, Bearers.Length > 1 ? Bearers[..^1] : Bearers);
        Tail = new TurnedChain(Skeleton, TailOf());
        Back = new TurnedChain(Skeleton, legs == null && Build != BodyBuild.Legless ? Spine : Array.Empty<int>());
        Ears = RootsOf(JointRole.Ear);
        Arms = subject.Limbs.Where(limb => limb.Kind == LimbKind.Arm && limb.Joints.Count == 6).ToArray();
        Fins = subject.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral || (limb.Kind == LimbKind.Wing && subject.Kind != LocomotionKind.Flying && !(legs != null && SpreadWings.Is(Skeleton, limb)))).ToArray();
        Wings = legs == null ? Array.Empty<int>() : subject.Limbs.Where(limb => limb.Kind is LimbKind.Wing or LimbKind.InsectWing).Select(limb => limb.Joints[0]).ToArray();
        Size = SizeOf();
        Unit = legs?.LegLength ?? Size / LegsPerBody;
        Depth = legs == null ? 0f : Math.Max(0f, Skeleton.ModelPositions[Body].Y - legs.BellyHeight);
        ChestHeight = legs == null ? 0f : ChestOf(subject, legs);
        if (legs != null)
        {
            ForeFeet = Pair(legs, legs.Rows - 1);
            HindFeet = Pair(legs, 0);
            int front = legs.Legs.Count(leg => legs.Front.Carries(leg)) / 2;
            FrontPairs = Enumerable.Range(0, front).Select(behind => Pair(legs, legs.Rows - 1 - behind)).ToArray();
        }

        LyingSide = legs != null && Array.Exists(legs.Legs, leg => leg.Row == 0 && leg.Lateral) ? LyingSide.Back : LyingSide.Flank;
        Has = PartsOf();
        Skin = BonePoints.Of(subject);
        TurnedChain[] feelers = Array.ConvertAll(RootsOf(JointRole.Antenna), root => new TurnedChain(Skeleton, Joints(JointRole.Antenna).Where(joint => Hangs(joint, root)).ToArray()));
        Feelers = Array.FindAll(feelers, feeler => !PointsBack(feeler));
        Trains = Array.FindAll(feelers, PointsBack);
        FeelerSkins = Array.ConvertAll(Feelers, feeler => Skin.Of(joint => Hangs(joint, feeler.Joints[0])));
        TrainSkins = Array.ConvertAll(Trains, train => Skin.Of(joint => Hangs(joint, train.Joints[0])));
        HeadChain = new TurnedChain(Skeleton, Head >= 0 ? new[] { Head } : Array.Empty<int>());
        HeadSkin = Skin.Of(joint => Hangs(joint, Bearers.Length > 0 ? Bearers[0] : -1) && !Array.Exists(feelers, feeler => Hangs(joint, feeler.Joints[0])));
        BearerSkins = Build == BodyBuild.Legless ? Array.ConvertAll(Bearers, bearer => Skin.Of(joint => joint == bearer)) : Array.Empty<BonePoints>();
        FaceSkin = Skin.Of(joint => Hangs(joint, Head) && !Array.Exists(feelers, feeler => Hangs(joint, feeler.Joints[0])));
        EarSkins = Array.ConvertAll(Joints(JointRole.Ear), ear => (ear, Skin.Of(joint => Hangs(joint, ear))));
        FurtherHeads = FurtherHeadsOf();
        JawSkin = Skin.Of(joint => Hangs(joint, Jaw));
        TailSkin = Skin.Of(joint => Hangs(joint, Tail.Count > 0 ? Tail.Joints[0] : -1));
        ArmSkins = Array.ConvertAll(Arms, arm => Skin.Of(joint => Hangs(joint, arm.Joints[1])));
        BearingSkin = Skin.Of(joint => !Hangs(joint, Bearers.Length > 0 ? Bearers[0] : -1) && !Hangs(joint, Tail.Count > 0 ? Tail.Joints[0] : -1) && !Array.Exists(Arms, arm => Hangs(joint, arm.Joints[1])));
        ShoulderSkin = BonePoints.EveryOf(subject, joint => Array.Exists(Arms, arm => joint == arm.Joints[1]));
        NeckSkin = Skin.Of(joint => joint != Head && Array.IndexOf(Bearers, joint) >= 0);
        FeetFromMiddle = legs == null ? Array.Empty<float>() : Array.ConvertAll(legs.Legs, leg => Skin.Of(joint => Hangs(joint, leg.Ankle)).FromMiddle(Skeleton, leg.Side));
        Tools = new ActTools(subject, Head, Jaw, Arms, Tail, BallsOf(ForeFeet), BallsOf(HindFeet));
    }

    public MotionSubject Subject { get; }

    public Skeleton Skeleton { get; }

    /// <summary>Its legs; null without any that it stands on.</summary>
    public LeggedBody? Legs { get; }

    public RestRotations Turns { get; }

    public BodyBuild Build { get; }

    /// <summary>What it has of what acts need.</summary>
    public ActNeeds Has { get; }

    /// <summary>Length of the body from its foremost to its rearmost joint, metres.</summary>
    public float Size { get; }

    /// <summary>The leg length of its acts, metres.</summary>
    public float Unit { get; }

    /// <summary>The joint that carries the trunk, and how far its belly is below that, metres; 0 without legs.</summary>
    public int Body { get; }

    public float Depth { get; }

    /// <summary>How high the lowest point of the chest between the fore legs stands, metres: not below the belly's lowest; 0 without legs.</summary>
    public float ChestHeight { get; }

    /// <summary>Joints from pelvis to chest, the chest with them.</summary>
    public int[] Spine { get; }

    /// <summary>Joints of the back that acts bend by themselves: of bodies that no legs carry.</summary>
    public TurnedChain Back { get; }

    /// <summary>Joints that bear the head, lowest first, and the head; of crawlers the front of the trunk with them.</summary>
    public int[] Bearers { get; }

    /// <summary>The same without the head, where there are others.</summary>
    public TurnedChain Neck { get; }

    /// <summary>The head's joint, −1 without.</summary>
    public int Head { get; }

    /// <summary>The jaw's joint, −1 without.</summary>
    public int Jaw { get; }

    public TurnedChain Tail { get; }

    /// <summary>The roots of the ears.</summary>
    public int[] Ears { get; }

    /// <summary>The head's joint alone; none without one.</summary>
    public TurnedChain HeadChain { get; }

    /// <summary>Each feeler, from its root.</summary>
    public TurnedChain[] Feelers { get; }

    /// <summary>Feelers that point back, and tails beside the tail.</summary>
    public TurnedChain[] Trains { get; }

    public LimbChain[] Arms { get; }

    /// <summary>Paired fins, and wings that do not fly.</summary>
    public LimbChain[] Fins { get; }

    /// <summary>The roots of wings that hang on a trunk on legs.</summary>
    public int[] Wings { get; }

    /// <summary>Left and right foot of the foremost pair, as indices of legs.</summary>
    public (int Left, int Right) ForeFeet { get; } = (-1, -1);

    /// <summary>The same of all pairs that a body on many raises with its front, foremost first.</summary>
    public (int Left, int Right)[] FrontPairs { get; } = Array.Empty<(int, int)>();

    /// <summary>Left and right foot of the rearmost pair.</summary>
    public (int Left, int Right) HindFeet { get; } = (-1, -1);

    /// <summary>How far the skin of each foot is from the middle of the body at rest, metres: as far it may go there without touching the other.</summary>
    public float[] FeetFromMiddle { get; }

    /// <summary>What it strikes with.</summary>
    public ActTools Tools { get; }

    /// <summary>What of the skin can touch the ground.</summary>
    public BonePoints Skin { get; }

    /// <summary>The same of neck and head without feelers, and of the tail.</summary>
    public BonePoints HeadSkin { get; }

    public BonePoints TailSkin { get; }

    /// <summary>The same of each joint of a crawler that bears its head; none of others.</summary>
    public BonePoints[] BearerSkins { get; }

    /// <summary>The same of the head alone.</summary>
    public BonePoints FaceSkin { get; }

    /// <summary>Joints of ears, those of each from its root, and the skin that hangs on each.</summary>
    public (int Joint, BonePoints Skin)[] EarSkins { get; }

    /// <summary>Heads beside the first one.</summary>
    public FurtherHead[] FurtherHeads { get; }

    /// <summary>The same of the jaw; none without one.</summary>
    public BonePoints JawSkin { get; }

    /// <summary>The same of each arm.</summary>
    public BonePoints[] ArmSkins { get; }

    /// <summary>The same of each feeler.</summary>
    public BonePoints[] FeelerSkins { get; }

    /// <summary>The same of each that points back.</summary>
    public BonePoints[] TrainSkins { get; }

    /// <summary>The same of trunk and legs: what a body lies on.</summary>
    public BonePoints BearingSkin { get; }

    /// <summary>The same of the shoulders of arms: a body on its flank lies on one, too.</summary>
    public BonePoints ShoulderSkin { get; }

    /// <summary>The same of the neck without the head: a body on its back lies on it, too.</summary>
    public BonePoints NeckSkin { get; }

    /// <summary>Where it comes to lie when it rolls over: on its back if its legs are out to the sides.</summary>
    public LyingSide LyingSide { get; }

    /// <summary>Seconds in which acts reckon: √(unit / gravity).</summary>
    public float TimeUnit(float gravity) => (float)Math.Sqrt(Unit / gravity);

    /// <summary>Whether a joint is, or hangs on, another.</summary>
    public bool Hangs(int joint, int from)
    {
        while (joint >= 0 && joint != from)
        {
            joint = Skeleton.Parents[joint];
        }

        return joint >= 0 && from >= 0;
    }

    private static (int Left, int Right) Pair(LeggedBody legs, int row)
    {
        int left = Array.FindIndex(legs.Legs, leg => leg.Row == row && leg.Side == Side.Left);
        int right = Array.FindIndex(legs.Legs, leg => leg.Row == row && leg.Side == Side.Right);
        return (left, right);
    }

    private bool PointsBack(TurnedChain feeler) => Skeleton.ModelPositions[feeler.Joints[^1]].Z < Skeleton.ModelPositions[feeler.Joints[0]].Z;

    private (int Left, int Right) BallsOf((int Left, int Right) feet) => (feet.Left < 0 ? -1 : Legs!.Legs[feet.Left].Ball, feet.Right < 0 ? -1 : Legs!.Legs[feet.Right].Ball);

    private static float ChestOf(MotionSubject subject, LeggedBody legs)
    {
        float hips = 0f;
        foreach (LegRig leg in legs.Legs)
        {
            hips = leg.Row == legs.Rows - 1 ? subject.Skeleton.ModelPositions[leg.Hip].Z : hips;
        }

        float lowest = float.MaxValue;
        ReadOnlySpan<Vector3> positions = subject.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            bool isTrunk = Array.IndexOf(legs.Trunk, subject.Mesh.Weights[v].Joint0) >= 0;
            lowest = isTrunk && Math.Abs(positions[v].Z - hips) < ChestLength * legs.LegLength ? Math.Min(lowest, positions[v].Y) : lowest;
        }

        return lowest == float.MaxValue ? legs.BellyHeight : Math.Max(lowest, legs.BellyHeight);
    }

    private static BodyBuild BuildOf(MotionSubject subject, LeggedBody? legs)
    {
        if (legs == null)
        {
            return subject.Kind switch
            {
                LocomotionKind.Swimming => BodyBuild.Swimming,
                LocomotionKind.Flying => BodyBuild.Airborne,
                _ => BodyBuild.Legless,
            };
        }

        if (subject.Kind == LocomotionKind.Swimming)
        {
            return BodyBuild.Swimming;
        }

        LegRig hind = Array.Find(legs.Legs, leg => leg.Row == 0)!;
        return legs.Rows > 2 ? BodyBuild.ManyLegged
            : hind.Lateral ? BodyBuild.Sprawling
            : legs.IsBiped ? subject.Plan == BodyPlan.Upright ? BodyBuild.Upright : BodyBuild.TwoLegged
            : hind.Traits.Kind.Outline.End == FootEnd.Hoof ? BodyBuild.Hoofed
            : hind.Traits.Kind.Outline.End == FootEnd.Pad ? BodyBuild.Columnar
            : BodyBuild.Pawed;
    }

    private ActNeeds PartsOf()
    {
        ActNeeds has = ActNeeds.None;
        Add(ActNeeds.Head, Head >= 0);
        Add(ActNeeds.Jaw, Jaw >= 0);
        Add(ActNeeds.Horns, Subject.HasHorns);
        Add(ActNeeds.Legs, Legs != null);
        Add(ActNeeds.FourLegs, Legs is { Rows: > 1 });
        Add(ActNeeds.Tail, Tail.Count > 0);
        Add(ActNeeds.LongTail, Tail.Count > 1 && Tail.Length > LongTailFraction * TrunkLength());
        Add(ActNeeds.Arms, Arms.Length > 0);
        Add(ActNeeds.Lids, Joints(JointRole.Lid).Length > 0);
        Add(ActNeeds.Sting, Subject.HasSting && Tail.Count > 0);
        Add(ActNeeds.Abdomen, Legs is { HasAbdomen: true } && Tail.Count > 0);
        Add(ActNeeds.Flanks, Legs != null && LyingSide == LyingSide.Flank);
        Add(ActNeeds.BareFlanks, Legs != null && LyingSide == LyingSide.Flank && !SpreadWings.Of(Subject));
        Add(ActNeeds.Front, Legs is { Front.Exists: true });
        Add(ActNeeds.Back, Legs != null && LyingSide == LyingSide.Back && !Subject.HasHorns && !SpreadWings.Of(Subject));
        return has;

        void Add(ActNeeds part, bool there) => has |= there ? part : ActNeeds.None;
    }

    private float TrunkLength() => Spine.Length == 0 ? Size : Vec.Distance(Skeleton.ModelPositions[Spine[0]], Skeleton.ModelPositions[Spine[^1]]);

    private FurtherHead[] FurtherHeadsOf() => Array.ConvertAll(Array.FindAll(Joints(JointRole.Head), joint => joint != Head), head =>
    {
        List<int> chain = ChainTo(head);
        int root = chain[0];
        if (chain.Count > 1)
        {
            chain.Remove(head);
        }

        return new FurtherHead(new TurnedChain(Skeleton, chain.ToArray()), new TurnedChain(Skeleton, new[] { head }), Skin.Of(joint => Hangs(joint, root)), Skin.Of(joint => Hangs(joint, head)));
    });

    /// <summary>A head and the joints of its neck, lowest first.</summary>
    private List<int> ChainTo(int head)
    {
        var chain = new List<int>();
        for (int joint = head; joint >= 0 && (joint == head || Skeleton.Joints[joint].Role == JointRole.Neck); joint = Skeleton.Parents[joint])
        {
            chain.Insert(0, joint);
        }

        return chain;
    }

    private int[] BearersOf()
    {
        List<int> chain = ChainTo(Head);
        if (Build == BodyBuild.Legless)
        {
            chain.InsertRange(0, Spine.Skip((int)((1f - RisingFraction) * Spine.Length)).Where(joint => !chain.Contains(joint)));
        }

        return chain.ToArray();
    }

    private int[] TailOf()
    {
        int[] tail = Joints(JointRole.Tail);
        return Build is BodyBuild.Legless or BodyBuild.Swimming ? Array.Empty<int>() : Legs is { HasAbdomen: true } ? tail.Skip((int)Math.Ceiling(StiffFraction * tail.Length)).ToArray() : tail;
    }

    private float SizeOf()
    {
        float rear = float.MaxValue;
        float front = float.MinValue;
        foreach (Vector3 place in Skeleton.ModelPositions)
        {
            rear = Math.Min(rear, place.Z);
            front = Math.Max(front, place.Z);
        }

        return Math.Max(front - rear, Legs?.HipHeight ?? 0f);
    }

    /// <summary>Joints of a role whose parents are of another.</summary>
    private int[] RootsOf(JointRole role) => Joints(role).Where(joint => Skeleton.Joints[Skeleton.Parents[joint]].Role != role).ToArray();

    private int[] Joints(params JointRole[] roles)
    {
        var found = new List<int>();
        for (int i = 0; i < Skeleton.Count; i++)
        {
            if (roles.Contains(Skeleton.Joints[i].Role))
            {
                found.Add(i);
            }
        }

        return found.ToArray();
    }
}
