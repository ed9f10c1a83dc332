using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>What feet do of a creature that stands for long.</summary>
public sealed class RestlessFeetTests
{
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Plantigrade)]
    [InlineData(BodyPlan.Columnar)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Upright)]
    public void Feet_step_now_and_then_one_at_a_time_stay_near_their_homes_and_do_not_slip(BodyPlan plan)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 3));
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Vector3[] homes = Enumerable.Range(0, animator.FootCount).Select(foot => animator.Foot(foot).Place).ToArray();
        Vector3[] planted = homes.ToArray();
        FootPhase[] phases = homes.Select(_ => FootPhase.Stance).ToArray();
        int steps = 0;
        float seconds = (float)(8 * profile.Legs!.Idle.Period) + 6f;
        for (int i = 0; i < (int)(seconds * 60f); i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            Assert.True(Enumerable.Range(0, homes.Length).Count(foot => animator.Foot(foot).Phase == FootPhase.Swing) < 2, $"{plan}: two feet are in the air");
            for (int foot = 0; foot < homes.Length; foot++)
            {
                FootReport report = animator.Foot(foot);
                Assert.True(Vec.Distance(report.Place, homes[foot]) < 0.08f * profile.LegLength, $"{plan}: foot {foot} is far from home");
                if (report.Phase == FootPhase.Stance)
                {
                    Assert.True(report.Residual < 0.002f * profile.LegLength, $"{plan}: foot {foot} is {report.Residual} m off its place");
                    Assert.True(phases[foot] == FootPhase.Swing || report.Place == planted[foot], $"{plan}: foot {foot} slid");
                    planted[foot] = report.Place;
                }

                steps += report.Phase == FootPhase.Stance && phases[foot] == FootPhase.Swing ? 1 : 0;
                phases[foot] = report.Phase;
            }
        }

        Assert.True(steps is >= 2 and <= 12, $"{plan}: {steps} steps in {seconds} s");
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, 0f)]
    [InlineData(BodyPlan.Sprawling, 1f)]
    public void Who_has_no_idle_life_or_legs_out_to_the_side_keeps_its_feet_where_they_are(BodyPlan plan, float idle)
    {
        var animator = new CreatureAnimator(Walkers.Of(plan, 3));
        animator.Settings = animator.Settings with { Idle = idle };
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        for (int i = 0; i < 60 * 60; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            Assert.Empty(animator.Events.ToArray());
        }
    }
}
