using System;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Rigging;

public sealed class JointLimitsTests
{
    [Fact]
    public void Every_archetype_has_limits_for_its_four_joints()
    {
        foreach (LimbArchetype archetype in Enum.GetValues<LimbArchetype>())
        {
            foreach (JointRole role in new[] { JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball })
            {
                JointLimit limit = JointLimits.Leg(archetype, role);
                Assert.True(limit.SwingX.Min < 0f && limit.SwingX.Max > 0f);
                Assert.True(limit.SwingX.Max - limit.SwingX.Min is > 0.8f and < 4.1f);
            }

            Assert.Throws<ArgumentOutOfRangeException>(() => JointLimits.Leg(archetype, JointRole.Spine));
        }
    }

    [Theory]
    [InlineData(5, 40)]
    [InlineData(10, 20)]
    [InlineData(2, 60)]
    public void A_chain_of_n_bones_bends_by_200_degrees_over_n_in_each_up_to_60(int bones, double degrees) =>
        Assert.Equal(degrees, CreatureGen.Maths.Scalar.Degrees(JointLimits.Chain(bones).SwingX.Max), 4);

    [Theory]
    [InlineData(24, 20)]
    [InlineData(12, 40)]
    [InlineData(2, 60)]
    public void A_body_of_n_bones_that_moves_by_waves_bends_by_480_degrees_over_n_in_each_up_to_60(int bones, double degrees)
    {
        JointLimit limit = JointLimits.Undulating(bones);
        Assert.Equal(Scalar.Radians(degrees), limit.SwingX.Max, 5);
        Assert.Equal(-Scalar.Radians(degrees), limit.SwingZ.Min, 5);
        Assert.Equal("-1..0.5", new AngleRange(-1f, 0.5f).ToString());
    }

    [Fact]
    public void Girth_narrows_a_bend_and_never_widens_it()
    {
        BodyShape shape = RigSubject.Of(BodyPlan.Sprawling).Input.Skin.Shape;
        var limit = new JointLimit(0.5f, 0.4f, 0.3f);
        JointLimit slim = JointLimits.WithinGirth(limit, 100f, shape, 30);
        Assert.Equal(limit, slim);
        JointLimit stout = JointLimits.WithinGirth(limit, 0.05f, shape, 30);
        Assert.Equal(0.64 * 0.05 / shape.Width[30], stout.SwingZ.Max, 5);
        Assert.True(stout.SwingX.Max < limit.SwingX.Max && stout.Twist == limit.Twist);
    }

    [Fact]
    public void The_mirrored_limit_keeps_x_and_turns_the_others_round()
    {
        var limit = new JointLimit(new AngleRange(-1f, 2f), new AngleRange(-0.1f, 0.4f), new AngleRange(-0.3f, 0.2f));
        Assert.Equal(new JointLimit(new AngleRange(-1f, 2f), new AngleRange(-0.4f, 0.1f), new AngleRange(-0.2f, 0.3f)), limit.Mirrored());
        Assert.Equal(limit, limit.Mirrored().Mirrored());
        Assert.Equal(0.4f, limit.SwingZ.Clamp(3f));
        Assert.Equal(-0.1f, limit.SwingZ.Clamp(-3f));
        Assert.Equal(0.2f, limit.SwingZ.Clamp(0.2f));
    }
}
