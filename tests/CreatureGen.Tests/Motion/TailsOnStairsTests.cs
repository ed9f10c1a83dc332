using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion;

public sealed class TailsOnStairsTests
{
    /// <summary>Three of thirty whose tails came .20 to .26 of a leg deep into the stairs behind them, for the ground was taken to be level there.</summary>
    [Theory]
    [InlineData(9970100)]
    [InlineData(9970102)]
    [InlineData(9970126)]
    public void Tails_keep_out_of_stairs_that_rise_behind_them(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Skeleton skeleton = profile.Subject.Skeleton;
        int[] tail = Enumerable.Range(0, skeleton.Count).Where(j => skeleton.Joints[j].Role == JointRole.Tail).ToArray();
        var course = new CourseSimulation(profile, CourseScripts.Runner(profile, 10f), CourseGround.Stairs, CourseRate.Of(60f));
        float deepest = 0f;
        foreach (float _ in course.Updates())
        {
            foreach (int joint in tail)
            {
                Vector3 place = course.Animator.Root.ToWorld(course.Animator.ModelPose.Positions[joint]);
                float below = course.Surface.HeightAt(place, 4f * profile.LegLength) is float height ? height - place.Y : 0f;
                deepest = Math.Max(deepest, below > 0f ? course.Surface.DepthOf(place, below, 4f * profile.LegLength) : 0f);
            }
        }

        Assert.NotEmpty(tail);
        Assert.True(deepest < 0.13f * profile.LegLength, $"{seed}: {deepest / profile.LegLength} of a leg");
    }
}
