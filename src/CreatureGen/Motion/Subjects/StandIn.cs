using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Retargeting;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Subjects;

/// <summary>A skeleton such as creatures grow, with its joints where those of a skeleton from elsewhere are: it is animated in that one's place. Immutable.</summary>
internal sealed class StandIn
{
    /// <summary>Part of the skeleton's height below which ankles stand.</summary>
    private const float Low = 0.3f;

    /// <summary>How far the ground is below the lowest joint of the feet where nobody says it, parts of the hip's height.</summary>
    private const float SoleThickness = 0.03f;

    /// <summary>Length of a chest, of which no joint tells, parts of the hip's height.</summary>
    private const float ChestAhead = 0.5f;

    /// <summary>Length of a last bone that nothing ends, parts of the one before.</summary>
    private const float LastBone = 0.6f;

    /// <summary>Part of a guessed length below which the skin at hand cannot be all that hangs on a last bone.</summary>
    private const float Shortest = 0.3f;

    /// <summary>Steepness of a trunk from which on it is upright: as high as it is long.</summary>
    private const float Upright = 1f;

    private readonly SkeletonBuilder builder = new();
    private readonly List<StandInLimb> legs;
    private readonly List<StandInLimb> arms;
    private readonly Skeleton source;
    private readonly SkeletonRoles roles;
    private readonly RestSkin? skin;
    private readonly int[] follows;
    private readonly Quaternion[] aligns;

    /// <summary>Makes one.</summary>
    /// <param name="skeleton">From elsewhere, facing +Z, +Y up.</param>
    /// <param name="ground">Height of the ground in its model space; null for where its soles are, or without a skin for just below the lowest joint of its feet.</param>
    /// <param name="unit">Metres in a unit of its space.</param>
    /// <param name="skin">How far its skin reaches; null where that is not known.</param>
    /// <exception cref="ArgumentException">It has no trunk or no pair of legs that stands, or the ground is not below its hips.</exception>
    public StandIn(Skeleton skeleton, float? ground, float unit, RestSkin? skin)
    {
        source = skeleton;
        this.skin = skin;
        Unit = unit;
        roles = new SkeletonRoles(skeleton);
        follows = new int[skeleton.Count];
        aligns = new Quaternion[skeleton.Count];
        Array.Fill(follows, -1);
        Array.Fill(aligns, Quaternion.Identity);
        if (roles.Trunk.Count == 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"the skeleton of {skeleton.Count} joints from {skeleton.Joints[0].Name} has no pelvis, spine or chest; expected one that carries its legs"), nameof(skeleton));
        }

        (List<LimbPair> standing, List<LimbPair> hanging) = Pairs();
        if (standing.Count == 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"the skeleton of {skeleton.Count} joints from {skeleton.Joints[0].Name} has no pair of legs that stands: a hip, a knee and a low ankle on the left and on the right; expected joints with roles, or names that tell them"), nameof(skeleton));
        }

        Ground = ground ?? GroundOf(standing);
        RequireBelow(standing);
        legs = standing.ConvertAll(pair => StandInLimb.Leg(pair, PlaceOf, ReachOf));
        arms = hanging.ConvertAll(pair => StandInLimb.Arm(pair, PlaceOf));
        int pelvis = AddTrunk(out int chest);
        AddHead(chest);
        AddTail(pelvis);
        var appendages = new List<Appendage>();
        var joined = new List<AppendageJoints>();
        for (int i = legs.Count - 1; i >= 0; i--)
        {
            Join(legs[i], LimbKind.Leg, legs.Count - i, OnColumns ? LimbArchetype.Column : legs[i].ArchetypeOf(i, legs.Count), appendages, joined);
        }

        for (int i = arms.Count - 1; i >= 0; i--)
        {
            Join(arms[i], LimbKind.Arm, arms.Count - i, LimbArchetype.Arm, appendages, joined);
        }

        Skeleton = builder.Build();
        Limbs = CreatureRigger.LimbChains(Skeleton, appendages, joined);
        Plan = PlanOf(Skeleton.ModelPositions[chest] - Skeleton.ModelPositions[pelvis]);
    }

    /// <summary>The skeleton that stands in, its feet on the plane of height 0.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>Its limbs.</summary>
    public IReadOnlyList<LimbChain> Limbs { get; }

    /// <summary>How its trunk and legs are laid out.</summary>
    public BodyPlan Plan { get; }

    /// <summary>Height of the ground in the other skeleton's model space.</summary>
    public float Ground { get; }

    /// <summary>Metres in a unit of that space.</summary>
    public float Unit { get; }

    /// <summary>The joint here that each joint of the other skeleton follows; −1 for none.</summary>
    public ReadOnlySpan<int> Follows => follows;

    /// <summary>From how each joint of the other skeleton is at rest to how it would be here, model space.</summary>
    public ReadOnlySpan<Quaternion> Aligns => aligns;

    /// <summary>Left limbs that have a right one, from behind: those that stand, and the others.</summary>
    private (List<LimbPair> Standing, List<LimbPair> Hanging) Pairs()
    {
        (float low, float high) = (float.MaxValue, float.MinValue);
        foreach (Vector3 p in source.ModelPositions)
        {
            (low, high) = (Math.Min(low, p.Y), Math.Max(high, p.Y));
        }

        (List<LimbPair> standing, List<LimbPair> hanging) = (new(), new());
        foreach ((int[] joints, Side side, int pair) in roles.Limbs)
        {
            if (side == Side.Left && joints[1] >= 0 && joints[2] >= 0 && RightOf(pair) is int[] right)
            {
                (source.ModelPositions[joints[2]].Y <= low + (Low * (high - low)) ? standing : hanging).Add(new LimbPair(joints, right));
            }
        }

        return (standing, hanging);
    }

    private int[]? RightOf(int pair)
    {
        foreach ((int[] joints, Side side, int other) in roles.Limbs)
        {
            if (side == Side.Right && other == pair && joints[1] >= 0 && joints[2] >= 0)
            {
                return joints;
            }
        }

        return null;
    }

    private float GroundOf(List<LimbPair> standing)
    {
        (float low, float hip, float sole) = (float.MaxValue, float.MinValue, float.MaxValue);
        foreach ((int[] joints, int[] right) in standing)
        {
            low = Math.Min(low, source.ModelPositions[joints[3] < 0 ? joints[2] : joints[3]].Y);
            hip = Math.Max(hip, source.ModelPositions[joints[0]].Y);
            sole = Math.Min(sole, Math.Min(SoleUnder(joints[2]), SoleUnder(right[2])));
        }

        return sole < hip ? sole : low - (SoleThickness * (hip - low));
    }

    private float SoleUnder(int ankle) => skin?.Farthest(ankle, -Vector3.UnitY)?.Y ?? float.MaxValue;

    private void RequireBelow(List<LimbPair> standing)
    {
        foreach ((int[] joints, _) in standing)
        {
            float hip = source.ModelPositions[joints[0]].Y;
            if (!(Ground < hip && hip - Ground < float.PositiveInfinity))
            {
                throw new ArgumentException(FormattableString.Invariant($"the ground is at height {Ground} and the hip {source.Joints[joints[0]].Name} at {hip}; expected ground below all hips"), "ground");
            }
        }
    }

    private Vector3 PlaceOf(int joint) => (source.ModelPositions[joint] - new Vector3(0f, Ground, 0f)) * Unit;

    /// <summary>How far skin reaches from a joint that it hangs on, metres; null where none is known.</summary>
    private float? ReachOf(int joint, Vector3 direction) =>
        skin?.Farthest(joint, direction) is Vector3 end ? Vec.Dot(end - source.ModelPositions[joint], direction) * Unit : null;

    /// <summary>Root, body, pelvis, spine and chest. A chest is made up where one joint is all the trunk.</summary>
    private int AddTrunk(out int chest)
    {
        var places = new List<Vector3>();
        foreach ((int joint, _) in roles.Trunk)
        {
            places.Add(Median(PlaceOf(joint)));
        }

        if (places.Count == 1)
        {
            places.Add(ChestBefore(places[0]));
        }
        else if (legs.Count > 1)
        {
            places[places.Count - 1] = ChestAtShoulders(places[places.Count - 1]);
        }

        builder.Add(-1, Side.Median, new JointDefinition("Root", JointRole.Root, Vector3.Zero, Quaternion.Identity, 0f, JointLimits.Body(JointRole.Root)));
        int parent = builder.Add(0, Side.Median, new JointDefinition("Body", JointRole.Body, (places[0] + places[places.Count - 1]) * 0.5f, Quaternion.Identity, 0f, JointLimits.Body(JointRole.Body)));
        int pelvis = parent + 1;
        for (int k = 0; k < places.Count; k++)
        {
            JointRole role = k == 0 ? JointRole.Pelvis : k == places.Count - 1 ? JointRole.Chest : JointRole.Spine;
            string name = role == JointRole.Spine ? FormattableString.Invariant($"Spine{k}") : role.ToString();
            Vector3 onward = k + 1 < places.Count ? places[k + 1] - places[k] : places[k] - places[k - 1];
            parent = builder.Add(parent, Side.Median, new JointDefinition(name, role, places[k], JointFrame.Median(onward), Vec.Length(onward), JointLimits.Body(role)));
            if (k < roles.Trunk.Count)
            {
                follows[roles.Trunk[k].Joint] = parent;
            }
        }

        chest = parent;
        return pelvis;
    }

    private Vector3 ChestBefore(Vector3 pelvis)
    {
        if (roles.Neck.Count > 0 || roles.Head.Count > 0)
        {
            return Median(PlaceOf((roles.Neck.Count > 0 ? roles.Neck : roles.Head)[0].Joint));
        }

        Vector3 foremost = legs[legs.Count - 1].Points[0];
        return legs.Count > 1 ? new Vector3(0f, pelvis.Y, foremost.Z) : pelvis + new Vector3(0f, ChestAhead * foremost.Y, 0f);
    }

    /// <summary>Where the last joint of a trunk is that legs hang on: at their hips. A trunk is pitched to bring that joint to its height, and hips far ahead of it would swing up and down with it.</summary>
    private Vector3 ChestAtShoulders(Vector3 last)
    {
        StandInLimb fore = legs[legs.Count - 1];
        int above = source.Parents[fore.Pair.Left[0]];
        while (above >= 0 && !roles.Trunk.Any(one => one.Joint == above))
        {
            above = source.Parents[above];
        }

        return above == roles.Trunk[roles.Trunk.Count - 1].Joint ? new Vector3(0f, last.Y, Math.Max(last.Z, fore.Points[0].Z)) : last;
    }

    private void AddHead(int chest)
    {
        if (roles.Head.Count > 0)
        {
            var chain = new List<(int Joint, float Part)>(roles.Neck) { roles.Head[0] };
            int head = AddChain(chain, chest, (k, count) => k < count - 1 ? (JointRole.Neck, FormattableString.Invariant($"Neck{k + 1}"), JointLimits.Chain(count - 1)) : (JointRole.Head, "Head", JointLimits.Body(JointRole.Head)));
            builder.AddEnd(head, Side.Median, "HeadEnd", EndOf(head));
            new StandInFace(builder, source, roles.Head[0].Joint, head, PlaceOf, ReachOf).Add(follows);
        }
    }

    private void AddTail(int pelvis)
    {
        if (roles.Tail.Count > 0)
        {
            int tip = AddChain(roles.Tail, pelvis, (k, count) => (JointRole.Tail, FormattableString.Invariant($"Tail{k + 1}"), JointLimits.Chain(count)));
            builder.AddEnd(tip, Side.Median, "TailEnd", EndOf(tip));
        }
    }

    private int AddChain(IReadOnlyList<(int Joint, float Part)> chain, int parent, Func<int, int, (JointRole Role, string Name, JointLimit Limit)> named)
    {
        for (int k = 0; k < chain.Count; k++)
        {
            Vector3 place = Median(PlaceOf(chain[k].Joint));
            Vector3 onward = k + 1 < chain.Count ? Median(PlaceOf(chain[k + 1].Joint)) - place : LastOf(chain[k].Joint, (place - builder[parent].Position) * LastBone);
            (JointRole role, string name, JointLimit limit) = named(k, chain.Count);
            parent = builder.Add(parent, Side.Median, new JointDefinition(name, role, place, JointFrame.Median(onward), Vec.Length(onward), limit));
            follows[chain[k].Joint] = parent;
        }

        return parent;
    }

    /// <summary>The last bone of a chain: as far as the skin goes on, or as guessed.</summary>
    private Vector3 LastOf(int joint, Vector3 guess)
    {
        Vector3 onward = Vec.Normalize(guess, Vector3.UnitZ);
        return ReachOf(joint, onward) is float reach && reach > Shortest * Vec.Length(guess) ? onward * reach : guess;
    }

    private Vector3 EndOf(int joint) => builder[joint].Position + Rotation.Rotate(builder[joint].Rotation, new Vector3(0f, builder[joint].Length, 0f));

    private void Join(StandInLimb limb, LimbKind kind, int pair, LimbArchetype archetype, List<Appendage> appendages, List<AppendageJoints> joined)
    {
        Vector3[] p = limb.Points;
        var appendage = new Appendage
        {
            Kind = kind,
            Pair = pair,
            Paired = true,
            Archetype = archetype,
            Joints = p,
            Pole = Vec.Normalize(Vec.Reject(p[1] - p[0], Vec.Normalize(p[2] - p[0], -Vector3.UnitY)), Vector3.UnitZ),
            Contact = new Vector3(p[3].X, kind == LimbKind.Leg ? 0f : p[3].Y, p[3].Z),
            Stands = kind == LimbKind.Leg,
        };
        AppendageJoints joints = LimbRigger.Add(builder, appendage, CarrierOf(limb.Pair.Left[0]));
        appendages.Add(appendage);
        joined.Add(joints);
        Follow(limb.Pair.Left, joints.Left, limb.AlignUpper, limb.AlignLower);
        Follow(limb.Pair.Right, joints.Right, Rotation.Mirror(limb.AlignUpper), Rotation.Mirror(limb.AlignLower));
    }

    /// <summary>Girdles come first in the limbs here.</summary>
    private void Follow(ReadOnlySpan<int> theirs, ReadOnlySpan<int> ours, Quaternion upper, Quaternion lower)
    {
        for (int k = 0; k < theirs.Length; k++)
        {
            if (theirs[k] >= 0)
            {
                follows[theirs[k]] = ours[k + 1];
                aligns[theirs[k]] = k == 0 ? upper : lower;
            }
        }
    }

    /// <summary>The joint here of the nearest joint of the trunk that a hip hangs on.</summary>
    private int CarrierOf(int hip)
    {
        for (int above = source.Parents[hip]; above >= 0; above = source.Parents[above])
        {
            if (follows[above] >= 0)
            {
                return follows[above];
            }
        }

        return follows[roles.Trunk[0].Joint];
    }

    private BodyPlan PlanOf(Vector3 trunk) =>
        legs[0].Lateral ? legs.Count switch { > 3 => BodyPlan.ManyLegged, 3 => BodyPlan.Hexapod, _ => BodyPlan.Sprawling }
            : legs.Count > 2 ? BodyPlan.ManyLegged
            : legs.Count == 2 ? (OnColumns ? BodyPlan.Columnar : BodyPlan.Digitigrade)
            : trunk.Y > Upright * Math.Abs(trunk.Z) ? BodyPlan.Upright : BodyPlan.Theropod;

    private bool OnColumns => legs.Count > 1 && legs.TrueForAll(leg => leg.IsColumn);

    private static Vector3 Median(Vector3 place) => new(0f, place.Y, place.Z);
}
