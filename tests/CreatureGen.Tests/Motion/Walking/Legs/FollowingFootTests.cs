using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Legs;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Legs;

public sealed class FollowingFootTests
{
    /// <summary>Their claws were dragged about the middle of the sole by each step (.0066 of a leg).</summary>
    [Fact]
    public void A_foot_of_claws_stays_as_it_was_set_down_while_its_ankle_twists_and_turns_with_its_leg_by_the_rest()
    {
        foreach (LegRig leg in Claws())
        {
            float twist = leg.Limits.AnkleTwist;
            Assert.Equal(Quaternion.Identity, At(leg, 0.8f * twist));
            Assert.Equal(Quaternion.Identity, At(leg, -0.8f * twist));
            float turned = (float)Rotation.Angle(At(leg, twist + 0.3f));
            Assert.InRange(turned, 0.3f, 0.3f + (0.2f * twist));
            Assert.True(leg.Limits.AnkleTwist > 0.2f);
        }
    }

    [Fact]
    public void It_turns_without_a_jump_as_its_leg_goes_on()
    {
        foreach (LegRig leg in Claws())
        {
            Quaternion before = At(leg, -0.7f);
            for (float sweep = -0.69f; sweep < 0.7f; sweep += 0.01f)
            {
                Quaternion now = At(leg, sweep);
                Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before), now)) < 0.02, $"{sweep} rad");
                before = now;
            }
        }
    }

    private static Quaternion At(LegRig leg, float sweep) =>
        FollowingFoot.Heading(leg, Quaternion.Identity, leg.HipRest + Rotation.Rotate(AxisRotation.Yaw(sweep), leg.Home - leg.HipRest));

    private static LegRig[] Claws()
    {
        LegRig[] legs = new MotionProfile(Walkers.Of(BodyPlan.Hexapod, 3)).Legs!.Legs;
        Assert.All(legs, leg => Assert.True(leg.Follows));
        return legs;
    }
}
