using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
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
            Assert.True(apart < 1e-2f * profile.LegLength, $"{plan}: {apart / profile.LegLength} legs apart");
        }
    }

    [Fact]
    public void An_insect_that_its_game_tilts_goes_from_the_floor_up_a_wall_and_along_the_ceiling_on_its_feet()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Hexapod, 2));
        float leg = profile.LegLength;
        var pipe = new Pipe(12f * leg);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, -12f * leg, 0f), Quaternion.Identity), pipe);
        float speed = 0.6f * MathF.Sqrt(Gravity * leg);
        float highest = float.MinValue;
        for (int i = 0; i < 1500 && highest < 11f * leg; i++)
        {
            animator.Settings = animator.Settings with { Up = pipe.UpAt(animator.Root.Position) };
            animator.Update(Frame, new MotionInput(speed), pipe);
            highest = Math.Max(highest, animator.Root.Position.Y);
            float radius = new Vector2(animator.Root.Position.Y, animator.Root.Position.Z).Length();
            Assert.Equal(BodyState.Supported, animator.State);
            Assert.True(Math.Abs(radius - (12f * leg)) < 0.3f * leg, $"{(12f * leg) - radius} m off the pipe");
        }

        Assert.True(highest >= 11f * leg, $"it came up to {highest / leg} legs");
    }

    /// <summary>The inside of a pipe along the X axis.</summary>
    private sealed class Pipe(float radius) : IGround
    {
        public Vector3 UpAt(Vector3 place) => Vector3.Normalize(new Vector3(0f, -place.Y, -place.Z));

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            // |o + t d|² = r² across the pipe, from within.
            float a = (direction.Y * direction.Y) + (direction.Z * direction.Z);
            float b = (origin.Y * direction.Y) + (origin.Z * direction.Z);
            float c = (origin.Y * origin.Y) + (origin.Z * origin.Z) - (radius * radius);
            float t = c >= 0f || a < 1e-9f ? 0f : (-b + MathF.Sqrt((b * b) - (a * c))) / a;
            Vector3 point = origin + (direction * t);
            hit = new GroundHit(point, UpAt(point));
            return t <= distance;
        }
    }
}
