using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

/// <summary>Skeletons whose names say little, as sample models of other programs have them.</summary>
public sealed class JointRolesTests
{
    [Fact]
    public void A_hip_that_carries_legs_of_both_sides_is_the_pelvis_and_legs_that_are_numbered_have_hips_of_their_own()
    {
        Skeleton fox = Build(
            ("b_Root_00", -1, 0f, 0f, 0f), ("b_Hip_01", 0, 0f, 0.43f, -0.27f), ("b_Spine01_02", 1, 0f, 0.12f, 0.05f), ("b_Head_05", 2, 0f, 0f, 0.5f),
            ("b_LeftLeg01_015", 1, 0.07f, 0.06f, -0.03f), ("b_LeftLeg02_016", 4, 0f, -0.19f, 0.02f), ("b_LeftFoot01_017", 5, 0f, -0.15f, -0.1f), ("b_LeftFoot02_018", 6, 0f, -0.15f, 0.05f),
            ("b_RightLeg01_019", 1, -0.07f, 0.06f, -0.03f), ("b_RightLeg02_020", 8, 0f, -0.19f, 0.02f), ("b_RightFoot01_021", 9, 0f, -0.15f, -0.1f), ("b_RightFoot02_022", 10, 0f, -0.15f, 0.05f),
            ("b_RightUpperArm_06", 2, -0.07f, -0.06f, 0.4f), ("b_RightForeArm_07", 12, 0f, -0.23f, 0f), ("b_RightHand_08", 13, 0f, -0.19f, 0f));
        Assert.Equal(JointRole.Pelvis, fox.Joints[1].Role);
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball], Roles(fox, 4, 4));
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball], Roles(fox, 8, 4));
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle], Roles(fox, 12, 3));
        Assert.All(fox.Joints.Skip(8), joint => Assert.Equal(Side.Right, joint.Side));
    }

    [Fact]
    public void Legs_and_arms_without_more_names_are_told_from_the_trunk_outwards_and_what_they_hang_on_is_the_pelvis()
    {
        Skeleton man = Build(
            ("Armature", -1, 0f, 0f, 0f), ("torso_joint_1", 0, 0f, 0.68f, 0f), ("torso_joint_2", 1, 0f, 0.15f, 0f), ("neck_joint_1", 2, 0f, 0.25f, 0f),
            ("arm_joint_L__4_", 2, 0.1f, 0.2f, 0f), ("arm_joint_L__3_", 4, 0.21f, -0.11f, 0f), ("arm_joint_L__2_", 5, 0.14f, -0.09f, 0.09f),
            ("arm_joint_R", 2, -0.1f, 0.2f, 0f), ("arm_joint_R__2_", 7, -0.21f, -0.11f, 0f), ("arm_joint_R__3_", 8, -0.14f, -0.09f, 0.09f),
            ("leg_joint_L_1", 1, 0.07f, -0.07f, 0f), ("leg_joint_L_2", 10, 0f, -0.26f, 0.05f), ("leg_joint_L_3", 11, 0f, -0.26f, -0.07f), ("leg_joint_L_5", 12, 0f, -0.07f, 0.03f),
            ("leg_joint_R_1", 1, -0.07f, -0.07f, 0f), ("leg_joint_R_2", 14, 0f, -0.26f, 0.05f), ("leg_joint_R_3", 15, 0f, -0.26f, -0.07f), ("leg_joint_R_5", 16, 0f, -0.07f, 0.03f));
        Assert.Equal([JointRole.Other, JointRole.Pelvis, JointRole.Spine, JointRole.Neck], Roles(man, 0, 4));
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle], Roles(man, 4, 3));
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball], Roles(man, 10, 4));
        Assert.Equal((Side.Left, Side.Right), (man.Joints[13].Side, man.Joints[17].Side));
    }

    [Fact]
    public void Limbs_without_any_names_are_pairs_of_chains_that_leave_the_midline()
    {
        (string, int, float, float, float)[] named =
        [
            ("Node_2", -1, 0f, 0f, 0f), ("Node_3", 0, 0f, 0.91f, 0f), ("Node_12", 1, 0f, 0.11f, -0.02f), ("Node_20", 2, 0f, 0.53f, 0f),
            ("Node_18", 2, -0.42f, 0.34f, -0.01f), ("Node_19", 4, -0.19f, 0f, 0f), ("Node_13", 2, 0.42f, 0.34f, -0.01f), ("Node_14", 6, 0.19f, 0f, 0f), ("Node_17", 7, 0.41f, 0f, 0f),
            ("Node_8", 1, -0.14f, -0.04f, 0f), ("Node_9", 9, 0.02f, -0.36f, -0.03f), ("Node_10", 10, 0f, -0.4f, -0.03f), ("Node_11", 11, 0f, -0.08f, 0.1f),
            ("Node_4", 1, 0.14f, -0.04f, 0f), ("Node_5", 13, -0.02f, -0.36f, -0.03f), ("Node_6", 14, 0f, -0.4f, -0.03f), ("Node_7", 15, 0f, -0.08f, 0.1f),
        ];
        Skeleton figure = Build(named);
        Assert.Equal(JointRole.Pelvis, figure.Joints[1].Role);
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball], Roles(figure, 9, 4));
        Assert.Equal([JointRole.Hip, JointRole.Knee, JointRole.Ankle], Roles(figure, 6, 3));
        Assert.Equal((Side.Right, Side.Left), (figure.Joints[9].Side, figure.Joints[16].Side));

        // Half of it is no pair, and the bones of a machine are none that stand.
        Assert.All(Build([.. named.Take(13).Where((_, i) => i is < 4 or > 8).Select(one => (one.Item1, one.Item2 > 8 ? one.Item2 - 5 : one.Item2, one.Item3, one.Item4, one.Item5))]).Joints, joint => Assert.Equal(JointRole.Other, joint.Role));
    }

    [Fact]
    public void What_is_said_of_joints_stays_and_twist_bones_and_fingers_are_no_limbs()
    {
        var said = new JointPlacement("LeftLeg", -1, Quaternion.Identity, Vector3.Zero) { Role = JointRole.Tail, Side = Side.Median };
        Assert.Equal((JointRole.Tail, Side.Median), Skeleton.Build([said]).Joints.Select(joint => (joint.Role, joint.Side)).Single());
        Skeleton arm = Build(("pelvis", -1, 0f, 1f, 0f), ("upperarm_l", 0, 0.2f, 0f, 0f), ("upperarm_twist_01_l", 1, 0.1f, 0f, 0f), ("lowerarm_l", 1, 0.3f, 0f, 0f), ("hand_l", 3, 0.3f, 0f, 0f), ("thumb_01_l", 4, 0.1f, 0f, 0f));
        Assert.Equal([JointRole.Pelvis, JointRole.Hip, JointRole.Other, JointRole.Knee, JointRole.Ankle, JointRole.Other], Roles(arm, 0, 6));
        Skeleton elbow = Build(("Pelvis", -1, 0f, 1f, 0f), ("Shoulder.L", 0, 0.2f, 0f, 0f), ("Elbow.L", 1, 0.3f, 0f, 0f), ("Wrist.L", 2, 0.3f, 0f, 0f));
        Assert.Equal([JointRole.Pelvis, JointRole.Hip, JointRole.Knee, JointRole.Ankle], Roles(elbow, 0, 4));
    }

    private static IEnumerable<JointRole> Roles(Skeleton skeleton, int first, int count) => skeleton.Joints.Skip(first).Take(count).Select(joint => joint.Role);

    [Theory]
    [InlineData("LeftEar", JointRole.Ear)]
    [InlineData("Bip01 L Ear", JointRole.Ear)]
    [InlineData("ear.R.001", JointRole.Ear)]
    [InlineData("mixamorig:LeftForeArm", JointRole.Knee)]
    [InlineData("L_Eye_jnt", JointRole.Eye)]
    [InlineData("rear_bone", JointRole.Other)]
    public void A_short_word_counts_where_it_is_a_part_of_the_name_by_itself(string name, JointRole role) => Assert.Equal(role, JointNames.RoleOf(name));

    [Fact]
    public void The_last_joint_of_a_neck_is_the_head_where_nothing_is_called_so()
    {
        Skeleton man = Build(("Hips", -1, 0f, 1f, 0f), ("Spine", 0, 0f, 0.3f, 0f), ("neck_joint_1", 1, 0f, 0.2f, 0f), ("neck_joint_2", 2, 0f, 0.1f, 0f));
        Assert.Equal([JointRole.Neck, JointRole.Head], Roles(man, 2, 2));
        Skeleton named = Build(("Hips", -1, 0f, 1f, 0f), ("Spine", 0, 0f, 0.3f, 0f), ("Neck1", 1, 0f, 0.2f, 0f), ("Neck2", 2, 0f, 0.1f, 0f), ("Head", 3, 0f, 0.1f, 0f));
        Assert.Equal([JointRole.Neck, JointRole.Neck, JointRole.Head], Roles(named, 2, 3));
    }

    private static Skeleton Build(params (string Name, int Parent, float X, float Y, float Z)[] joints) =>
        Skeleton.Build([.. joints.Select(one => new JointPlacement(one.Name, one.Parent, Quaternion.Identity, new Vector3(one.X, one.Y, one.Z)))]);
}
