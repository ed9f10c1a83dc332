using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class SkeletonTests
{
    [Fact]
    public void Counterparts_differ_in_one_letter()
    {
        var skeleton = new Skeleton(new[]
        {
            Make("Root", Side.Median, -1), Make("LL_L1", Side.Left, 0), Make("LL_L2", Side.Left, 0), Make("LL_R1", Side.Right, 0), Make("RR_R2", Side.Right, 0), Make("LL_R2", Side.Right, 0),
        });
        Assert.Equal(new[] { 0, 3, 5, 1, 4, 2 }, skeleton.Mirrors.ToArray());
    }

    [Fact]
    public void The_spans_repeat_the_joints()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Centaur).Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            Joint joint = skeleton.Joints[j];
            Assert.Equal((joint.Parent, joint.LocalPosition, joint.LocalRotation), (skeleton.Parents[j], skeleton.LocalPositions[j], skeleton.LocalRotations[j]));
            Assert.Equal((joint.ModelPosition, joint.ModelRotation), (skeleton.ModelPositions[j], skeleton.ModelRotations[j]));
            Assert.Equal(j, skeleton.IndexOf(joint.Name));
        }
    }

    [Fact]
    public void Joints_that_are_no_tree_of_plain_names_are_refused()
    {
        Refused("joint 0 (A) has parent 0; expected", Make("A", Side.Median, 0));
        Refused("joint 1 (B) has parent -1; expected", Make("A", Side.Median, -1), Make("B", Side.Median, -1));
        Refused("\"A\" is empty or used twice", Make("A", Side.Median, -1), Make("A", Side.Median, 0));
        Refused("\"Knee 1\"; expected letters", Make("Knee 1", Side.Median, -1));
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_joint_that_is_nowhere_never_leaves_the_rigger(float y)
    {
        var builder = new SkeletonBuilder();
        builder.Add(-1, Side.Median, new JointDraft("Lost", JointRole.Root, new Vector3(0f, y, 0f), Quaternion.Identity, 1f, JointLimit.Free));
        InvalidOperationException error = Assert.Throws<InvalidOperationException>(() => builder.Build());
        Assert.Contains("\"Lost\" has a place or an orientation that is not finite", error.Message, StringComparison.Ordinal);
    }

    private static void Refused(string message, params Joint[] joints)
    {
        ArgumentException error = Assert.Throws<ArgumentException>(() => new Skeleton(joints));
        Assert.Contains(message, error.Message, StringComparison.Ordinal);
    }

    private static Joint Make(string name, Side side, int parent) =>
        new(name, JointRole.Spine, side, parent, Vector3.Zero, Quaternion.Identity, Vector3.Zero, Quaternion.Identity, 1f, JointLimit.Free);
}
