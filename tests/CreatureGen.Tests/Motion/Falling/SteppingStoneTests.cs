using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Sampling;
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

    /// <summary>Two theropods that fell as they walked, one that fell as it stood on two stones, and a sprawler that put a foot between them: 15 to 17 of 59 runners did, 11 walkers and 4 over gaps.</summary>
    [Theory]
    [InlineData(14020014, 1)]
    [InlineData(9920020, 1)]
    [InlineData(14020051, 1)]
    [InlineData(9920025, 1)]
    [InlineData(14030000, 40, Explicit = true)]
    public void Nobody_falls_between_stones_or_into_gaps_at_any_pace(ulong first, int count)
    {
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
            if (profile.Gaits is null)
            {
                continue;
            }

            CourseCommand walk = new(Seconds, new MotionInput(profile.Gaits.Speeds[0].Comfortable));
            CourseCommand stop = new(2f, default);
            foreach (CourseGround ground in new[] { CourseGround.Stones, CourseGround.Gap })
            {
                foreach (CourseScript script in new[] { CourseScripts.Runner(profile, Seconds), new CourseScript("walk", [walk, stop]) })
                {
                    var run = new CourseSimulation(profile, script, ground, CourseRate.Of(60f));
                    int steps = 0;
                    int onNothing = 0;
                    foreach (float dt in run.Updates())
                    {
                        Assert.True(run.Animator.State == BodyState.Supported, FormattableString.Invariant($"{seed} {script.Name} {ground}: {run.Animator.State} at {run.Animator.Root.Position.Z / profile.LegLength}"));
                        foreach (ref readonly MotionEvent e in run.Animator.Events)
                        {
                            if (e.Kind == MotionEventKind.FootDown)
                            {
                                steps++;
                                onNothing += run.Surface.HeightAt(e.Position, profile.LegLength) is null ? 1 : 0;
                            }
                        }
                    }

                    Assert.True(onNothing <= 0.02f * steps, FormattableString.Invariant($"{seed} {script.Name} {ground}: {onNothing} of {steps} feet come down on nothing"));
                }
            }
        }
    }

    /// <summary>A slit is below the middle of a body, and its feet are on both sides of it.</summary>
    [Fact]
    public void Who_comes_down_astride_a_slit_lands_on_its_feet()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(520, 4))
        {
            float leg = profile.LegLength;
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            // As far below as all of them take with their legs.
            var slit = new Holed(-0.95f * leg, point => MathF.Abs(point.X) < 0.08f * leg);
            bool fell = false;
            for (int i = 0; i < 240; i++)
            {
                animator.Update(1f / 60f, default, slit);
                fell |= animator.State == BodyState.Falling;
            }

            Assert.True(fell);
            Assert.NotEqual(BodyState.Falling, animator.State);
            Assert.InRange(animator.Root.Position.Y / leg, -1.15f, -0.75f);
        }
    }
}
