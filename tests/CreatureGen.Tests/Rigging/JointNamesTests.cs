using CreatureGen.Anatomy;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class JointNamesTests
{
    [Theory]
    [InlineData(BodyPlan.Centaur)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Buzzing)]
    [InlineData(BodyPlan.Fish)]
    public void Names_of_grown_joints_say_what_they_are(BodyPlan plan)
    {
        foreach (Joint joint in RigSubject.Of(plan).Skeleton.Joints)
        {
            Assert.Equal((joint.Name, joint.Role, joint.Side), (joint.Name, JointNames.RoleOf(joint.Name), JointNames.SideOf(joint.Name)));
        }
    }

    [Theory]
    [InlineData("mixamorig:LeftUpLeg", JointRole.Hip, Side.Left)]
    [InlineData("mixamorig:LeftLeg", JointRole.Knee, Side.Left)]
    [InlineData("mixamorig:RightForeArm", JointRole.Knee, Side.Right)]
    [InlineData("mixamorig:RightToeBase", JointRole.Ball, Side.Right)]
    [InlineData("mixamorig:Hips", JointRole.Pelvis, Side.Median)]
    [InlineData("Bip01 L Thigh", JointRole.Hip, Side.Left)]
    [InlineData("Bip01 R Foot", JointRole.Ankle, Side.Right)]
    [InlineData("upper_arm.R", JointRole.Hip, Side.Right)]
    [InlineData("shin.L", JointRole.Knee, Side.Left)]
    [InlineData("spine.003", JointRole.Spine, Side.Median)]
    [InlineData("Armature", JointRole.Other, Side.Median)]
    public void Names_of_other_programs_are_understood(string name, JointRole role, Side side) =>
        Assert.Equal((role, side), (JointNames.RoleOf(name), JointNames.SideOf(name)));
}
