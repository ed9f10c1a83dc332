using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Subjects;

/// <summary>What is around the bones of a stand-in: its skin, or where nothing is known of that, a capsule around each bone with points on it, and soles on the ground. Immutable.</summary>
internal sealed class StandInFlesh
{
    /// <summary>Kilograms for each cubic metre.</summary>
    private const float Density = 1000f;

    /// <summary>Radius of a bone at the least, parts of the hip's height: a bone that skin follows in one place alone has no thickness by that.</summary>
    private const float Thinnest = 0.02f;

    /// <summary>Points of the skin around each end of a bone.</summary>
    private const int Around = 6;

    private readonly List<CapsuleCollider> bones = new();
    private readonly List<Vector3> points = new();
    private readonly List<SkinWeights> weights = new();

    /// <summary>Takes the skin as it is.</summary>
    /// <param name="skeleton">The stand-in's.</param>
    /// <param name="skin">At rest around it.</param>
    /// <param name="mass">Kilograms; null for what the flesh weighs.</param>
    /// <exception cref="ArgumentException">The skin is around none of its bones.</exception>
    public StandInFlesh(Skeleton skeleton, CreatureMesh skin, float? mass)
    {
        float min = Thinnest * skeleton.ModelPositions[skeleton.FirstOf(JointRole.Hip)].Y;
        foreach (CapsuleCollider bone in BoneCapsules.Fit(skeleton, skin.Weights, skin.Positions))
        {
            bones.Add(bone.Radius >= min ? bone : new CapsuleCollider(bone.Joint, Vector3.Zero, new Vector3(0f, skeleton.Joints[bone.Joint].Length, 0f), min));
        }

        if (bones.Count == 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"a skin of {skin.Positions.Length} vertices of which no bone moves any number; expected one around the skeleton"), nameof(skin));
        }

        Bones = bones;
        Mass = MassOf(skeleton, mass);
        Skin = skin;
    }

    /// <summary>Puts guessed flesh on bones.</summary>
    /// <param name="skeleton">The stand-in's.</param>
    /// <param name="limbs">Its limbs.</param>
    /// <param name="mass">Kilograms; null for what the flesh weighs.</param>
    public StandInFlesh(Skeleton skeleton, IReadOnlyList<LimbChain> limbs, float? mass)
    {
        float leg = 0f;
        float aside = 0f;
        foreach (LimbChain limb in limbs)
        {
            Vector3 hip = skeleton.ModelPositions[limb.Joints[1]];
            leg = limb.Stands ? Math.Max(leg, hip.Y) : leg;
            aside = limb.Stands ? Math.Max(aside, Math.Abs(hip.X)) : aside;
        }

        for (int j = 0; j < skeleton.Count; j++)
        {
            float radius = RadiusOf(skeleton.Joints[j].Role, leg, aside);
            if (radius > 0f && skeleton.Joints[j].Length > 0f)
            {
                Cover(skeleton, j, Math.Min(radius, 0.8f * skeleton.Joints[j].Length + (0.02f * leg)));
            }
        }

        foreach (LimbChain limb in limbs)
        {
            if (limb.Stands)
            {
                AddSole(skeleton, limb, leg);
            }
        }

        Bones = bones;
        Mass = MassOf(skeleton, mass);
        Skin = new CreatureMesh(points.ToArray(), new Vector3[points.Count], new Vector2[points.Count], new Vector3[points.Count], weights.ToArray(), Array.Empty<int>(), Array.Empty<MeshPart>());
    }

    /// <summary>A capsule for each bone.</summary>
    public IReadOnlyList<CapsuleCollider> Bones { get; }

    /// <summary>Vertices of the skin, without triangles.</summary>
    public CreatureMesh Skin { get; }

    /// <summary>Mass and inertia.</summary>
    public MassProperties Mass { get; }

    /// <summary>How thick a bone is, metres: of the trunk by how far apart the hips are, of limbs by how long they are.</summary>
    private static float RadiusOf(JointRole role, float leg, float aside)
    {
        float trunk = Math.Max(1.1f * aside, 0.15f * leg);
        return role switch
        {
            JointRole.Pelvis or JointRole.Spine or JointRole.Chest => trunk,
            JointRole.Neck => 0.5f * trunk,
            JointRole.Head => 0.7f * trunk,
            JointRole.Tail => 0.2f * trunk,
            JointRole.Hip => 0.08f * leg,
            JointRole.Knee => 0.06f * leg,
            JointRole.Ankle => 0.045f * leg,
            JointRole.Ball => 0.035f * leg,
            _ => 0f,
        };
    }

    /// <summary>A capsule along a bone, and skin on it, none of it below the ground.</summary>
    private void Cover(Skeleton skeleton, int joint, float radius)
    {
        var end = new Vector3(0f, skeleton.Joints[joint].Length, 0f);
        bones.Add(new CapsuleCollider(joint, Vector3.Zero, end, radius));
        for (int k = 0; k < 2 * Around; k++)
        {
            double turn = 2 * Math.PI * (k % Around) / Around;
            Vector3 across = new((float)(radius * PortableMath.Cos(turn)), 0f, (float)(radius * PortableMath.Sin(turn)));
            AddPoint(skeleton, joint, (k < Around ? Vector3.Zero : end) + across);
        }

        AddPoint(skeleton, joint, end + new Vector3(0f, radius, 0f));
    }

    private void AddPoint(Skeleton skeleton, int joint, Vector3 place)
    {
        Vector3 p = skeleton.ModelPositions[joint] + Rotation.Rotate(skeleton.ModelRotations[joint], place);
        Add(joint, new Vector3(p.X, Math.Max(p.Y, 0f), p.Z));
    }

    /// <summary>Tip of the toes, both sides of the ball, and the heel where that is low.</summary>
    private void AddSole(Skeleton skeleton, LimbChain limb, float leg)
    {
        Vector3 ankle = skeleton.ModelPositions[limb.Joints[3]];
        Vector3 ball = skeleton.ModelPositions[limb.Joints[4]];
        Vector3 tip = skeleton.ModelPositions[limb.Joints[5]];
        Vector3 ahead = Vec.Normalize(new Vector3(tip.X - ball.X, 0f, tip.Z - ball.Z), Vector3.UnitZ);
        var beside = new Vector3(ahead.Z, 0f, -ahead.X);
        float width = 0.04f * leg;
        float heel = limb.Archetype is { } kind && LegKinds.Of(kind).Outline is { FlatSoled: true, Lateral: false, End: FootEnd.Toes } ? Math.Max(Vec.Dot(ball - ankle, ahead), width) : width;
        Vector3 under = new(ball.X, 0f, ball.Z);
        Add(limb.Joints[4], new Vector3(tip.X, 0f, tip.Z));
        Add(limb.Joints[4], under + (beside * width));
        Add(limb.Joints[4], under - (beside * width));
        Add(limb.Joints[4], under - (ahead * heel));
    }

    private void Add(int joint, Vector3 place)
    {
        points.Add(place);
        weights.Add(new SkinWeights(joint, 0, 0, 0, Vector4.UnitX));
    }

    /// <summary>The bones' capsules as points in their middles.</summary>
    private MassProperties MassOf(Skeleton skeleton, float? mass)
    {
        float volume = 0f;
        Vector3 centre = Vector3.Zero;
        var parts = new List<(Vector3 Place, float Volume)>();
        foreach (CapsuleCollider bone in bones)
        {
            Vector3 place = skeleton.ModelPositions[bone.Joint] + Rotation.Rotate(skeleton.ModelRotations[bone.Joint], (bone.Start + bone.End) * 0.5f);
            float part = (float)Math.PI * bone.Radius * bone.Radius * (Vec.Distance(bone.Start, bone.End) + (4f / 3f * bone.Radius));
            parts.Add((place, part));
            volume += part;
            centre += place * part;
        }

        centre /= volume;
        float whole = mass ?? (Density * volume);
        Vector3 diagonal = Vector3.Zero;
        Vector3 products = Vector3.Zero;
        foreach ((Vector3 place, float part) in parts)
        {
            Vector3 r = place - centre;
            float m = whole * part / volume;
            diagonal += m * new Vector3((r.Y * r.Y) + (r.Z * r.Z), (r.X * r.X) + (r.Z * r.Z), (r.X * r.X) + (r.Y * r.Y));
            products -= m * new Vector3(r.X * r.Y, r.Y * r.Z, r.Z * r.X);
        }

        return new MassProperties(whole, volume, centre, diagonal, products);
    }
}
