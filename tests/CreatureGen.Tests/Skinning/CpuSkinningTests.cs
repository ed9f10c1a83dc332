using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class CpuSkinningTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_rest_pose_reproduces_the_rest_mesh(BodyPlan plan)
    {
        RigSubject subject = RigSubject.Of(plan);
        Vector3[] rest = subject.Input.Surface.Positions;
        Vector3[] normals = SkinFacts.Normals(rest, subject.Input.Surface.Triangles.ToArray());
        (Vector3[] moved, Vector3[] movedNormals) = subject.Bend(subject.Weights, normals, _ => null);
        for (int v = 0; v < rest.Length; v++)
        {
            Assert.True(Vec.Distance(rest[v], moved[v]) <= 1e-6f);
            Assert.True(Vec.Distance(normals[v], movedNormals[v]) <= 1e-6f);
        }
    }

    [Fact]
    public void At_rest_the_matrices_are_exactly_the_identity()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Centaur).Skeleton;
        var pose = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        pose.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, pose, pose);
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, pose, matrices);
        Assert.All(matrices, m => Assert.Equal(Matrix4x4.Identity, m));
    }

    [Fact]
    public void Any_pose_agrees_with_transforming_by_every_joint_and_taking_the_mean()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Sprawling);
        Skeleton skeleton = subject.Skeleton;
        Surface surface = subject.Input.Surface;
        Vector3[] normals = SkinFacts.Normals(surface.Positions, surface.Triangles.ToArray());
        (Quaternion[] rotations, Vector3[] positions) = Anything(skeleton);
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, new Pose(rotations, positions), matrices);
        var moved = new Vector3[surface.Positions.Length];
        var movedNormals = new Vector3[surface.Positions.Length];
        CpuSkinning.Skin(matrices, subject.Weights, surface.Positions, normals, moved, movedNormals);
        for (int v = 0; v < moved.Length; v++)
        {
            Vector3 p = Vector3.Zero;
            Vector3 n = Vector3.Zero;
            foreach ((int joint, float weight) in subject.Weights[v].Influences())
            {
                Quaternion inverse = Rotation.Inverse(skeleton.ModelRotations[joint]);
                Vector3 local = Rotation.Rotate(inverse, surface.Positions[v] - skeleton.ModelPositions[joint]);
                p += (Rotation.Rotate(rotations[joint], local) + positions[joint]) * weight;
                n += Rotation.Rotate(rotations[joint], Rotation.Rotate(inverse, normals[v])) * weight;
            }

            Assert.True(Vec.Distance(p, moved[v]) < 5e-6f);
            Assert.True(Vec.Length(n) < 0.02f || Vec.Distance(Vec.Normalize(n), movedNormals[v]) < 2e-4f);
            Assert.Equal(1f, Vec.Length(movedNormals[v]), 1e-5f);
        }
    }

    [Fact]
    public void Many_vertices_at_once_give_the_bits_of_one_alone_over_themselves_too()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Sprawling);
        Skeleton skeleton = subject.Skeleton;
        Vector3[] rest = subject.Input.Surface.Positions[..101];
        Vector3[] normals = SkinFacts.Normals(subject.Input.Surface.Positions, subject.Input.Surface.Triangles.ToArray())[..101];
        (Quaternion[] rotations, Vector3[] positions) = Anything(skeleton);
        var matrices = new Matrix4x4[skeleton.Count];
        SkinMatrices.Fill(skeleton, new Pose(rotations, positions), matrices);

        // A joint that takes all length from normals, and any number of influences.
        matrices[1] = default;
        SkinWeights[] weights = subject.Weights[..101];
        weights[6] = new SkinWeights(1, 0, 0, 0, Vector4.UnitX);
        weights[13] = new SkinWeights(2, 3, 0, 0, new Vector4(0.6f, 0.4f, 0f, 0f));
        weights[21] = new SkinWeights(2, 3, 4, 0, new Vector4(0.5f, 0.3f, 0.2f, 0f));
        weights[30] = new SkinWeights(5, 3, 4, 2, new Vector4(0.4f, 0.3f, 0.2f, 0.1f));
        var moved = (Vector3[])rest.Clone();
        var movedNormals = (Vector3[])normals.Clone();
        CpuSkinning.Skin(matrices, weights, moved, movedNormals, moved, movedNormals);
        var alone = new Vector3[1];
        var normalAlone = new Vector3[1];
        for (int v = 0; v < rest.Length; v++)
        {
            CpuSkinning.Skin(matrices, weights.AsSpan(v, 1), rest.AsSpan(v, 1), normals.AsSpan(v, 1), alone, normalAlone);
            Assert.Equal(Bits(alone[0]), Bits(moved[v]));
            Assert.Equal(Bits(normalAlone[0]), Bits(movedNormals[v]));
        }

        Assert.Equal(normals[6], movedNormals[6]);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void An_influence_without_a_matrix_is_refused_wherever_it_is_and_a_slot_without_weight_is_not(int slot)
    {
        var vertices = new Vector3[6];
        var weights = new SkinWeights[6];
        Array.Fill(weights, new SkinWeights(0, 0, 0, 0, Vector4.UnitX));
        int[] joints = new int[4];
        joints[slot] = 9;
        float[] parts = new float[4];
        Array.Fill(parts, 1f / (slot + 1), 0, slot + 1);
        weights[2] = new SkinWeights(joints[0], joints[1], joints[2], joints[3], new Vector4(parts[0], parts[1], parts[2], parts[3]));
        Assert.Throws<IndexOutOfRangeException>(() => CpuSkinning.Skin(new Matrix4x4[1], weights, vertices, vertices, vertices, vertices));
        if (slot > 0)
        {
            weights[2] = new SkinWeights(joints[0], joints[1], joints[2], joints[3], Vector4.UnitX);
            CpuSkinning.Skin(new Matrix4x4[1], weights, vertices, vertices, vertices, vertices);
        }
    }

    [Fact]
    public void Turning_the_root_turns_the_skin_as_one()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Flapping);
        Vector3[] rest = subject.Input.Surface.Positions;
        Quaternion turn = Rotation.FromAxisAngle(Vec.Normalize(new Vector3(1f, 2f, -1f)), 1.1);
        (Vector3[] moved, _) = subject.Bend(subject.Weights, SkinFacts.Normals(rest, subject.Input.Surface.Triangles.ToArray()), j => j.Role == JointRole.Root ? turn : null);
        for (int v = 0; v < rest.Length; v++)
        {
            Assert.True(Vec.Distance(Rotation.Rotate(turn, rest[v]), moved[v]) < 5e-6f);
        }
    }

    [Fact]
    public void Skinning_allocates_nothing()
    {
        RigSubject subject = RigSubject.Of(BodyPlan.Fish);
        Vector3[] rest = subject.Input.Surface.Positions;
        Vector3[] normals = SkinFacts.Normals(rest, subject.Input.Surface.Triangles.ToArray());
        Quaternion[] rotations = subject.Skeleton.ModelRotations.ToArray();
        Vector3[] positions = subject.Skeleton.ModelPositions.ToArray();
        var matrices = new Matrix4x4[subject.Skeleton.Count];
        var moved = new Vector3[rest.Length];
        var movedNormals = new Vector3[rest.Length];
        SkinWeights[] weights = subject.Weights;
        Assert.Equal(0, MovingPose.Allocated(Skin));

        void Skin()
        {
            SkinMatrices.Fill(subject.Skeleton, new Pose(rotations, positions), matrices);
            CpuSkinning.Skin(matrices, weights, rest, normals, moved, movedNormals);
        }
    }

    [Fact]
    public void Spans_that_do_not_fit_are_refused()
    {
        var one = new Vector3[1];
        var weights = new SkinWeights[] { new(5, 0, 0, 0, Vector4.UnitX) };
        ArgumentException error = Assert.Throws<ArgumentException>(() => CpuSkinning.Skin(new Matrix4x4[1], weights, one, new Vector3[2], one, one));
        Assert.Contains("1 weights, 1 and 1 positions, 2 and 1 normals; expected one of each", error.Message, StringComparison.Ordinal);
        Assert.Throws<IndexOutOfRangeException>(() => CpuSkinning.Skin(new Matrix4x4[1], weights, one, one, one, one));
        Skeleton skeleton = RigSubject.Of(BodyPlan.Fish).Skeleton;
        Assert.Throws<ArgumentException>(() => SkinMatrices.Fill(skeleton, new Pose(skeleton.ModelRotations.ToArray(), skeleton.ModelPositions.ToArray()), new Matrix4x4[3]));
    }

    private static (int X, int Y, int Z) Bits(Vector3 v) => (BitConverter.SingleToInt32Bits(v.X), BitConverter.SingleToInt32Bits(v.Y), BitConverter.SingleToInt32Bits(v.Z));

    private static (Quaternion[] Rotations, Vector3[] Positions) Anything(Skeleton skeleton)
    {
        RandomStream random = new Seed(17).Stream();
        var rotations = new Quaternion[skeleton.Count];
        var positions = new Vector3[skeleton.Count];
        for (int j = 0; j < skeleton.Count; j++)
        {
            float N() => (float)random.Normal(0, 1);
            rotations[j] = Rotation.Normalize(new Quaternion(N(), N(), N(), N()));
            positions[j] = new Vector3(N(), N(), N());
        }

        return (rotations, positions);
    }
}
