using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>What wings of walkers look like as these carry them.</summary>
public sealed class CarriedWingShapeTests
{
    /// <summary>Most that they stand above the back, in its height: skin that the flank holds but the arm turned was a spike of .6.</summary>
    private const float Highest = 0.35f;

    [Theory]
    [InlineData(22000009)]
    [InlineData(22000124)]
    [InlineData(22000135)]
    public void Folded_wings_of_walkers_do_not_stand_up_as_spikes(int seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Creature creature = profile.Subject.Creature!;
        var skin = new Vector3[creature.Mesh.Positions.Length];
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, skin, new Vector3[skin.Length]);
        float wing = Top(JointRole.Wing);
        float back = Math.Max(Top(JointRole.Spine), Top(JointRole.Pelvis));
        Assert.True(wing > 0f, "it has wings");
        Assert.True((wing - back) / back < Highest, FormattableString.Invariant($"{(wing - back) / back} of the back's height above it"));

        float Top(JointRole role) => Enumerable.Range(0, skin.Length).Where(v => creature.Skeleton.Joints[creature.Mesh.Weights[v].Joint0].Role == role).Max(v => skin[v].Y);
    }
}
