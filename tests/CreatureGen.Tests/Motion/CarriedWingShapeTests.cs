using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>What wings of walkers look like as these carry them.</summary>
public sealed class CarriedWingShapeTests
{
    /// <summary>How far an arm is turned with its rear edge up, radians.</summary>
    private const float Turned = 0.6f;

    /// <summary>Most that skin of wings which lies beside the trunk goes up as the arm is turned, in the height of the back: what the flank holds was a spike of .17 to .19 over it where it turned with the arm.</summary>
    private const float Highest = 0.12f;

    [Theory]
    [InlineData(24230001)]
    [InlineData(24241007)]
    [InlineData(22000124)]
    public void The_flank_holds_the_inner_edge_of_raised_membranes(int seed)
    {
        Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        Skeleton skeleton = creature.Skeleton;
        var pose = new Pose(skeleton.LocalRotations.ToArray(), skeleton.LocalPositions.ToArray());
        int shoulder = skeleton.IndexOf("Wing_L1_1");
        pose.Rotations[shoulder] = Rotation.Multiply(AxisRotation.Pitch(Turned), pose.Rotations[shoulder]);
        var model = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        ForwardKinematics.LocalToModel(skeleton, pose, model);
        Vector3[] rest = creature.Mesh.Positions.ToArray();
        var skin = new Vector3[rest.Length];
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, model, matrices);
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, skin, new Vector3[skin.Length]);
        int[] trunk = Enumerable.Range(0, rest.Length).Where(v => Moves(v, JointRole.Wing) == 0f && Moves(v, JointRole.Spine) > 0.5f).ToArray();
        float breadth = trunk.Max(v => rest[v].X);
        float back = trunk.Max(v => rest[v].Y);
        float raised = Enumerable.Range(0, rest.Length).Where(v => rest[v].X > 0f && rest[v].X < breadth && Moves(v, JointRole.Wing) > 0f).Max(v => skin[v].Y - rest[v].Y);
        Assert.True(raised < Highest * back, FormattableString.Invariant($"raised by {raised / back} of the back's height"));

        float Moves(int vertex, JointRole role)
        {
            SkinWeights w = creature.Mesh.Weights[vertex];
            return Of(w.Joint0, w.Weights.X) + Of(w.Joint1, w.Weights.Y) + Of(w.Joint2, w.Weights.Z) + Of(w.Joint3, w.Weights.W);

            float Of(int joint, float weight) => skeleton.Joints[joint].Role == role ? weight : 0f;
        }
    }
}
