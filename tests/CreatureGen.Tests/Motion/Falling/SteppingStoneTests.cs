using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

public sealed class SteppingStoneTests
{
    private const float Seconds = 8f;

    /// <summary>Leg lengths below which the root is never while feet find stones.</summary>
    private const float Deepest = 0.5f;

    /// <summary>A digitigrade, a plantigrade, a hexapod and two hoofed ones that fell between the stones for good at a run, as they were then (<see cref="KeptCreatures"/>).</summary>
    [Theory]
    [InlineData(9920002)]
    [InlineData(9920015)]
    [InlineData(9920018)]
    [InlineData(9920019)]
    [InlineData(9920034)]
    public void Who_runs_over_stepping_stones_comes_down_on_stones(ulong seed)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        var run = new CourseSimulation(profile, CourseScripts.Runner(profile, Seconds), CourseGround.Stones, CourseRate.Of(60f));
        float farthest = 0f;
        foreach (float dt in run.Updates())
        {
            CreatureAnimator animator = run.Animator;
            farthest = Math.Max(farthest, animator.Root.Position.Z / profile.LegLength);
            Assert.NotEqual(BodyState.Falling, animator.State);
            Assert.True(animator.Root.Position.Y > -Deepest * profile.LegLength, FormattableString.Invariant($"{animator.Root.Position} after {farthest} legs"));
        }

        Assert.True(farthest > 10f, FormattableString.Invariant($"only {farthest} legs"));
    }
}
