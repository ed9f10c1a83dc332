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
    /// <summary>Most that skin of wings which lies beside the trunk at rest goes up, in the height of the back: what the flank holds was a spike of .25 where the arm turned it.</summary>
    private const float Highest = 0.1f;

    [Theory]
    [InlineData(24230001)]
    [InlineData(24241007)]
    [InlineData(22000124)]
    public void The_flank_holds_the_inner_edge_of_raised_membranes(int seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Creature creature = profile.Subject.Creature!;
        Vector3[] rest = creature.Mesh.Positions.ToArray();
        var skin = new Vector3[rest.Length];
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, skin, new Vector3[skin.Length]);
        int[] trunk = Enumerable.Range(0, rest.Length).Where(v => Moves(v, JointRole.Wing) == 0f && Moves(v, JointRole.Spine) > 0.5f).ToArray();
        float breadth = trunk.Max(v => rest[v].X);
        float back = trunk.Max(v => rest[v].Y);
        int[] beside = Enumerable.Range(0, rest.Length).Where(v => Moves(v, JointRole.Wing) > 0f && Math.Abs(rest[v].X) < breadth).ToArray();
        Assert.True(skin.Max(v => v.Y) > 1.3f * back, "it has raised its wings");
        float raised = beside.Max(v => skin[v].Y - rest[v].Y);
        Assert.True(raised < Highest * back, FormattableString.Invariant($"raised by {raised / back} of the back's height"));

        float Moves(int vertex, JointRole role)
        {
            SkinWeights w = creature.Mesh.Weights[vertex];
            return Of(w.Joint0, w.Weights.X) + Of(w.Joint1, w.Weights.Y) + Of(w.Joint2, w.Weights.Z) + Of(w.Joint3, w.Weights.W);

            float Of(int joint, float weight) => creature.Skeleton.Joints[joint].Role == role ? weight : 0f;
        }
    }
}
