using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class ForwardKinematicsTests
{
    [Theory]
    [MemberData(nameof(RigSubject.Plans), MemberType = typeof(RigSubject))]
    public void The_rest_pose_is_the_bind_pose_to_the_bit(BodyPlan plan)
    {
        foreach (Skeleton skeleton in new[] { RigSubject.Of(plan).Skeleton, RigSubject.Of(plan).Rig.Scaled(1.37f).Skeleton })
        {
            var rotations = new Quaternion[skeleton.Count];
            var positions = new Vector3[skeleton.Count];
            var pose = new Pose(rotations, positions);
            pose.SetToRest(skeleton);
            ForwardKinematics.LocalToModel(skeleton, pose, pose);
            Assert.Equal(skeleton.ModelRotations.ToArray(), rotations);
            Assert.Equal(skeleton.ModelPositions.ToArray(), positions);
        }
    }

    [Fact]
    public void Any_pose_agrees_with_the_walk_from_each_joint_to_the_root()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Flapping).Skeleton;
        (Quaternion[] rotations, Vector3[] positions) = Anything(skeleton, 7);
        var modelRotations = new Quaternion[skeleton.Count];
        var modelPositions = new Vector3[skeleton.Count];
        ForwardKinematics.LocalToModel(skeleton, new Pose(rotations, positions), new Pose(modelRotations, modelPositions));
        for (int j = 0; j < skeleton.Count; j++)
        {
            Vector3 p = Vector3.Zero;
            Vector3 y = Vector3.UnitY;
            for (int k = j; k >= 0; k = skeleton.Parents[k])
            {
                p = Rotation.Rotate(rotations[k], p) + positions[k];
                y = Rotation.Rotate(rotations[k], y);
            }

            Assert.True(Vec.Distance(p, modelPositions[j]) < 2e-5f);
            Assert.True(Vec.Distance(y, Rotation.Rotate(modelRotations[j], Vector3.UnitY)) < 1e-5f);
        }
    }

    [Fact]
    public void A_pose_can_be_chained_in_place()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Hexapod).Skeleton;
        (Quaternion[] rotations, Vector3[] positions) = Anything(skeleton, 3);
        var modelRotations = new Quaternion[skeleton.Count];
        var modelPositions = new Vector3[skeleton.Count];
        ForwardKinematics.LocalToModel(skeleton, new Pose(rotations, positions), new Pose(modelRotations, modelPositions));
        ForwardKinematics.LocalToModel(skeleton, new Pose(rotations, positions), new Pose(rotations, positions));
        Assert.Equal(modelRotations, rotations);
        Assert.Equal(modelPositions, positions);
    }

    [Fact]
    public void A_mirrored_pose_moves_the_mirrored_joints_to_the_bit()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Digitigrade).Skeleton;
        (Quaternion[] rotations, Vector3[] positions) = Anything(skeleton, 11);
        var mirroredRotations = new Quaternion[skeleton.Count];
        var mirroredPositions = new Vector3[skeleton.Count];
        for (int j = 0; j < skeleton.Count; j++)
        {
            mirroredRotations[skeleton.Mirrors[j]] = Rotation.Mirror(rotations[j]);
            mirroredPositions[skeleton.Mirrors[j]] = Vec.Mirror(positions[j]);
        }

        ForwardKinematics.LocalToModel(skeleton, new Pose(rotations, positions), new Pose(rotations, positions));
        ForwardKinematics.LocalToModel(skeleton, new Pose(mirroredRotations, mirroredPositions), new Pose(mirroredRotations, mirroredPositions));
        for (int j = 0; j < skeleton.Count; j++)
        {
            Assert.Equal(Vec.Mirror(positions[j]), mirroredPositions[skeleton.Mirrors[j]]);
            Assert.Equal(Rotation.Mirror(rotations[j]), mirroredRotations[skeleton.Mirrors[j]]);
        }
    }

    [Fact]
    public void Chaining_allocates_nothing()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Fish).Skeleton;
        var rotations = new Quaternion[skeleton.Count];
        var positions = new Vector3[skeleton.Count];
        Assert.Equal(0, MovingPose.Allocated(() => Run(skeleton, rotations, positions)));
    }

    [Fact]
    public void Spans_of_the_wrong_length_are_refused()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Fish).Skeleton;
        Assert.Throws<ArgumentException>(() => new Pose(new Quaternion[2], new Vector3[3]).Positions.Length);
        ArgumentException error = Assert.Throws<ArgumentException>(() => new Pose(new Quaternion[2], new Vector3[2]).SetToRest(skeleton));
        Assert.Contains("a pose of 2 joints; expected the ", error.Message, StringComparison.Ordinal);
    }

    private static void Run(Skeleton skeleton, Quaternion[] rotations, Vector3[] positions)
    {
        var pose = new Pose(rotations, positions);
        pose.SetToRest(skeleton);
        ForwardKinematics.LocalToModel(skeleton, pose, pose);
    }

    private static (Quaternion[] Rotations, Vector3[] Positions) Anything(Skeleton skeleton, ulong seed)
    {
        RandomStream random = new Seed(seed).Stream();
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
