using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Walls and ceilings are ground whose up is another.</summary>
public sealed class WallTests
{
    private const float Frame = 1f / 60f;
    private const float Gravity = 9.80665f;

    /// <summary>Ways up and ahead on floors, walls and ceilings.</summary>
    public static TheoryData<Vector3, Vector3> Sides => new()
    {
        { -Vector3.UnitZ, Vector3.UnitY },
        { Vector3.UnitX, -Vector3.UnitY },
        { -Vector3.UnitY, Vector3.UnitZ },
    };

    [Theory]
    [MemberData(nameof(Sides))]
    public void A_gecko_and_an_insect_go_on_a_wall_or_a_ceiling_as_they_go_on_the_floor(Vector3 up, Vector3 ahead)
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Sprawling, BodyPlan.Hexapod })
        {
            var profile = new MotionProfile(Walkers.Of(plan, 2));
            float unit = MathF.Sqrt(Gravity * profile.LegLength);
            var floor = new CreatureAnimator(profile);
            var wall = new CreatureAnimator(profile);
            wall.Settings = wall.Settings with { Up = up };
            var side = new FlatGround(Vector3.Zero, up);
            floor.Teleport(RootPlace.Identity, FlatGround.Level);
            wall.Teleport(new RootPlace(Vector3.Zero, Rotation.FromBasis(Vector3.Cross(up, ahead), up, ahead)), side);
            float apart = 0f;
            for (int i = 0; i < 480; i++)
            {
                var input = i < 240 ? new MotionInput(0.6f * unit) : new MotionInput(0.2f * unit, 1f);
                floor.Update(Frame, input, FlatGround.Level);
                wall.Update(Frame, input, side);
                for (int j = 0; j < profile.Subject.Skeleton.Count; j++)
                {
                    apart = Math.Max(apart, Vector3.Distance(floor.ModelPose.Positions[j], wall.ModelPose.Positions[j]));
                }
            }

            Assert.Equal(BodyState.Supported, wall.State);
            Assert.True(apart < 1e-3f * profile.LegLength, $"{plan}: {apart / profile.LegLength} legs apart");
        }
    }

    [Fact]
    public void An_insect_that_its_game_tilts_goes_from_the_floor_up_a_wall_and_along_the_ceiling_on_its_feet()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Hexapod, 2));
        float leg = profile.LegLength;
        var pipe = new PipeSurface(12f * leg);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, pipe.Ground);
        float speed = 0.6f * MathF.Sqrt(Gravity * leg);
        float highest = float.MinValue;
        for (int i = 0; i < 1500 && highest < 23f * leg; i++)
        {
            animator.Settings = animator.Settings with { Up = pipe.UpAt(animator.Root.Position) };
            animator.Update(Frame, new MotionInput(speed), pipe.Ground);
            highest = Math.Max(highest, animator.Root.Position.Y);
            float radius = new Vector2(animator.Root.Position.Y - (12f * leg), animator.Root.Position.Z).Length();
            Assert.Equal(BodyState.Supported, animator.State);
            Assert.True(Math.Abs(radius - (12f * leg)) < 0.3f * leg, $"{(12f * leg) - radius} m off the pipe");
        }

        Assert.True(highest >= 23f * leg, $"it came up to {highest / leg} legs");
    }

    [Fact]
    public void A_course_in_a_pipe_leads_a_sprawler_over_its_ceiling_with_its_feet_below_itself()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Sprawling, 2));
        var script = new CourseScript("round", [new CourseCommand(20f, new MotionInput(0.6f * MathF.Sqrt(Gravity * profile.LegLength)))]);
        var course = new CourseSimulation(profile, script, CourseGround.Pipe, CourseRate.Of(60f));
        float highest = 0f;
        foreach (float _ in course.Updates())
        {
            Vector3 up = course.Surface.UpAt(course.Animator.Root.Position);
            Assert.Equal(BodyState.Supported, course.Animator.State);
            Assert.True(Vector3.Dot(up, Rotation.Rotate(course.Animator.Root.Rotation, Vector3.UnitY)) > 0.99f);
            Vector3 below = course.Surface.Below(course.Animator.Root.Position)!.Value;
            Assert.True(Vector3.Distance(below, course.Animator.Root.Position) < 0.3f * profile.LegLength);
            highest = Math.Max(highest, course.Animator.Root.Position.Y);
        }

        Assert.True(highest > 23f * profile.LegLength, $"it came up to {highest / profile.LegLength} legs");
    }
}
