using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;

namespace CreatureGen.Tests.Motion;

/// <summary>A flier on its feet, and its skin as it is posed.</summary>
internal sealed class StandingFlier
{
    /// <summary>Slices of a body, from nose to tail, in which its back is as high as its highest skin.</summary>
    private const int Slices = 30;

    private readonly bool[] wing;
    private readonly JointRole[] roles;

    private StandingFlier(MotionProfile profile)
    {
        Profile = profile;
        Animator = new CreatureAnimator(profile);
        Animator.Settings = Animator.Settings with { Idle = 0f };
        Skin = new Vector3[Creature.Mesh.Positions.Length];
        roles = Creature.Skeleton.Joints.Select(joint => joint.Role).ToArray();
        wing = roles.Select(role => role == JointRole.Wing).ToArray();
    }

    public MotionProfile Profile { get; }

    public CreatureAnimator Animator { get; }

    /// <summary>The skin in model space, as of the last <see cref="Go"/>.</summary>
    public Vector3[] Skin { get; }

    public Creature Creature => Profile.Subject.Creature!;

    public string Name => $"{Creature.Blueprint.Seed} {Creature.Blueprint.Body.Blend.First}";

    public bool IsStitched => Creature.Blueprint.Wings.Count > 0;

    /// <summary>From the nose to the tip of the tail, metres.</summary>
    public double Length => Profile.Flight!.Chain.Length;

    /// <summary>Those animals of some seeds that stand on legs.</summary>
    public static IEnumerable<StandingFlier> Of(int firstSeed, int count) => Of(firstSeed, count, CreatureOptions.Default with { Strangeness = 0 });

    /// <summary>Those fliers of some seeds that stand on legs.</summary>
    public static IEnumerable<StandingFlier> Of(int firstSeed, int count, CreatureOptions options) => Enumerable.Range(firstSeed, count)
        .Select(seed => new MotionProfile(CreatureGenerator.Generate((ulong)seed, options with { Kind = RequestedKind.Flying })))
        .Where(profile => profile.Legs != null)
        .Select(profile => new StandingFlier(profile));

    /// <summary>Puts it on its feet at the origin.</summary>
    public void Stand(IGround ground)
    {
        Animator.Teleport(RootPlace.Identity, ground);
        Pose();
    }

    /// <summary>Lets it go.</summary>
    public void Go(float seconds, float speed, IGround ground)
    {
        Walkers.Run(Animator, seconds, 60f, new MotionInput(speed), ground);
        Pose();
    }

    /// <summary>Skin that a wing alone moves.</summary>
    public IEnumerable<Vector3> Wings()
    {
        for (int v = 0; v < Skin.Length; v++)
        {
            SkinWeights weights = Creature.Mesh.Weights[v];
            if (wing[weights.Joint0] && weights.Weights.X > 0.9f)
            {
                yield return Skin[v];
            }
        }
    }

    /// <summary>How far wings stand above the back below them at the most, body lengths.</summary>
    public double AboveBack()
    {
        var backs = new Dictionary<int, float>();
        for (int v = 0; v < Skin.Length; v++)
        {
            if (roles[Creature.Mesh.Weights[v].Joint0] is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Tail)
            {
                backs[Slice(Skin[v])] = Math.Max(backs.GetValueOrDefault(Slice(Skin[v]), float.MinValue), Skin[v].Y);
            }
        }

        return Wings().Where(point => backs.ContainsKey(Slice(point))).Max(point => point.Y - backs[Slice(point)]) / Length;

        int Slice(Vector3 point) => (int)Math.Floor(Slices * point.Z / Length);
    }

    /// <summary>Place of the first joint of a role, model space.</summary>
    public Vector3 PlaceOf(JointRole role) => Animator.ModelPose.Positions[Array.FindIndex(roles, r => r == role)];

    /// <summary>Where the tail is thinner than 0.6 of the pelvis for the first time.</summary>
    public Vector3 TailBase()
    {
        float girth = Creature.Bones.First(bone => Creature.Skeleton.Joints[bone.Joint].Role == JointRole.Pelvis).Radius;
        CapsuleCollider[] tail = Creature.Bones.Where(bone => Creature.Skeleton.Joints[bone.Joint].Role == JointRole.Tail).ToArray();
        return Animator.ModelPose.Positions[(tail.FirstOrDefault(bone => bone.Radius < 0.6f * girth) ?? tail.Last()).Joint];
    }

    /// <summary>How deep the wings are in the legs, by the capsules of these, leg lengths.</summary>
    public double InLegs()
    {
        double deepest = 0;
        foreach (CapsuleCollider bone in Creature.Bones.Where(bone => Creature.Skeleton.Joints[bone.Joint].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball))
        {
            Vector3 joint = Animator.ModelPose.Positions[bone.Joint];
            Quaternion turn = Animator.ModelPose.Rotations[bone.Joint];
            Vector3 start = joint + Rotation.Rotate(turn, bone.Start);
            Vector3 end = joint + Rotation.Rotate(turn, bone.End);
            foreach (Vector3 point in Wings())
            {
                deepest = Math.Max(deepest, bone.Radius - Math.Sqrt(SegmentDistance.Squared(point, point, start, end)));
            }
        }

        return deepest / Profile.LegLength;
    }

    private void Pose()
    {
        var matrices = new Matrix4x4[Creature.Skeleton.Count];
        SkinMatrices.Fill(Creature.Skeleton, Animator.ModelPose, matrices);
        CpuSkinning.Skin(matrices, Creature.Mesh.Weights, Creature.Mesh.Positions, Creature.Mesh.Normals, Skin, new Vector3[Skin.Length]);
    }
}
