using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
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
        Refused("\"A\" is used twice", Make("A", Side.Median, -1), Make("A", Side.Median, 0));
        Refused("joint 0 has no name", Make(string.Empty, Side.Median, -1));
        Refused("joint 0 has U+000A in its name", Make("A\nB", Side.Median, -1));
        Refused("joint 0 has U+D800 in its name", Make("A\ud800", Side.Median, -1));
        Refused("a skeleton of no joints");
    }

    [Fact]
    public void What_a_joint_says_of_itself_is_proved()
    {
        Joint sound = Make("A", Side.Median, -1);
        Refused("its position in its parent is (0, NaN, 0)", sound with { LocalPosition = new Vector3(0f, float.NaN, 0f) });
        Refused("its position in the model is (Infinity, 0, 0)", sound with { ModelPosition = new Vector3(float.PositiveInfinity, 0f, 0f) });
        Refused("its rotation in the model is (0, 0, 0, 0); expected a unit", sound with { ModelRotation = default });
        Refused("its rotation in its parent is (0, 0, 0, NaN)", sound with { LocalRotation = new Quaternion(0f, 0f, 0f, float.NaN) });
        Refused("its length is -1", sound with { Length = -1f });
        Refused("its length is NaN", sound with { Length = float.NaN });
        Refused("its bone points along (0, 2, 0)", sound with { Along = new Vector3(0f, 2f, 0f) });
        Refused("its twist is 0.1..0.2 radians", sound with { Limit = new JointLimit(AngleRange.Both(1f), AngleRange.Both(1f), new AngleRange(0.1f, 0.2f)) });
        Refused("it has no limit", sound with { Limit = null! });
        Joint child = Make("B", Side.Median, 0);
        Refused("joint B: its place in the model is 0.01 m and 0 rad from", sound, child with { ModelPosition = new Vector3(0f, 0.01f, 0f) });
        Refused("joint B: its place in the model is 0 m and 0.0", sound, child with { LocalRotation = Rotation.FromAxisAngle(Vector3.UnitZ, 0.01) });
    }

    [Fact]
    public void Names_of_other_programs_are_kept()
    {
        Skeleton skeleton = Skeleton.Build(
        [
            new("mixamorig:Hips", -1, Quaternion.Identity, Vector3.UnitY),
            new("Bip01 L Thigh", 0, Quaternion.Identity, Vector3.UnitX) { Side = Side.Left },
            new("Bip01 R Thigh", 0, Quaternion.Identity, -Vector3.UnitX) { Side = Side.Right },
            new("尻尾.001", 0, Quaternion.Identity, -Vector3.UnitZ),
            new("mixamorig:LeftArm", 0, Quaternion.Identity, Vector3.UnitX) { Side = Side.Left },
            new("mixamorig:RightArm", 0, Quaternion.Identity, -Vector3.UnitX) { Side = Side.Right },
        ]);
        Assert.Equal(3, skeleton.IndexOf("尻尾.001"));
        Assert.Equal(new[] { 0, 2, 1, 3, 5, 4 }, skeleton.Mirrors.ToArray());
    }

    [Fact]
    public void Local_transforms_alone_give_the_grown_skeleton_again()
    {
        Skeleton grown = RigSubject.Of(BodyPlan.Centaur).Skeleton;
        Skeleton built = Skeleton.Build(grown.Joints.Select(j => new JointPlacement(j.Name, j.Parent, j.LocalRotation, j.LocalPosition) { Role = j.Role, Side = j.Side, Limit = j.Limit }).ToArray());
        for (int j = 0; j < grown.Count; j++)
        {
            Assert.True(Vec.Distance(grown.ModelPositions[j], built.ModelPositions[j]) < 1e-5f);
            if (grown.Joints[j].Length > 0f && grown.Joints[j].Role is JointRole.Neck or JointRole.Tail or JointRole.Knee or JointRole.Ankle)
            {
                Assert.InRange(built.Joints[j].Length, grown.Joints[j].Length * 0.9999f, grown.Joints[j].Length * 1.0001f);
                Assert.True(Vec.Distance(built.Joints[j].Along, Vector3.UnitY) < 1e-3f, grown.Joints[j].Name);
            }
        }
    }

    [Fact]
    public void A_bone_points_at_the_child_with_the_longest_chain_and_goes_straight_on_when_they_are_equal()
    {
        Skeleton skeleton = Skeleton.Build(
        [
            new("Hips", -1, Rotation.FromAxisAngle(Vector3.UnitX, 1), new Vector3(0f, 1f, 0f)),
            new("Thigh", 0, Quaternion.Identity, new Vector3(0.2f, 0f, 0f)),
            new("Spine", 0, Quaternion.Identity, new Vector3(0f, 0f, 0.5f)),
            new("Wrist", 2, Rotation.FromAxisAngle(Vector3.UnitY, 0.5), new Vector3(0f, 0f, 0.5f)),
            new("Thumb", 3, Quaternion.Identity, new Vector3(0.1f, 0f, 0f)),
            new("Middle", 3, Rotation.FromAxisAngle(Vector3.UnitY, -0.5), Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, -0.5), new Vector3(0f, 0f, 0.1f))),
            new("Same place", 3, Quaternion.Identity, Vector3.Zero),
        ]);
        Assert.Equal(Vector3.UnitZ, skeleton.Joints[0].Along);
        Assert.Equal(0.5f, skeleton.Joints[0].Length);
        Assert.Equal(0.1f, skeleton.Joints[3].Length, 6);
        Assert.True(Vec.Distance(Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, -0.5), Vector3.UnitZ), skeleton.Joints[3].Along) < 1e-6f);
        Assert.True(Vec.Distance(Vector3.UnitZ, skeleton.Joints[5].Along) < 1e-6f);
        Assert.Equal(0f, skeleton.Joints[5].Length);
        Assert.Equal(Vector3.UnitY, skeleton.Joints[6].Along);
    }

    [Fact]
    public void Placements_that_make_no_skeleton_are_refused()
    {
        Assert.Throws<ArgumentNullException>(() => Skeleton.Build(null!));
        Assert.Contains("no joints", Assert.Throws<ArgumentException>(() => Skeleton.Build([])).Message, StringComparison.Ordinal);
        Assert.Contains("its rotation is (0, 0, 0, 0)", Assert.Throws<ArgumentException>(() => Skeleton.Build([new("A", -1, default, Vector3.Zero)])).Message, StringComparison.Ordinal);
        Assert.Contains("has parent 3", Assert.Throws<ArgumentException>(() => Skeleton.Build([new("A", 3, Quaternion.Identity, Vector3.Zero)])).Message, StringComparison.Ordinal);
        Assert.Contains("NaN", Assert.Throws<ArgumentException>(() => Skeleton.Build([new("A", -1, Quaternion.Identity, new Vector3(float.NaN))])).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Rotations_of_any_length_are_brought_to_one()
    {
        Skeleton skeleton = Skeleton.Build([new("A", -1, new Quaternion(0f, 3f, 0f, 4f), Vector3.Zero)]);
        Assert.Equal(new Quaternion(0f, 0.6f, 0f, 0.8f), skeleton.LocalRotations[0]);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_joint_that_is_nowhere_never_leaves_the_rigger(float y)
    {
        var builder = new SkeletonBuilder();
        builder.Add(-1, Side.Median, new JointDefinition("Lost", JointRole.Root, new Vector3(0f, y, 0f), Quaternion.Identity, 1f, JointLimit.Free));
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
