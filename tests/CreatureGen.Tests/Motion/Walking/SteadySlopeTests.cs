using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

public sealed class SteadySlopeTests
{
    private const float Rate = 30f;

    /// <summary>Degrees beyond which frogs' leaps go beyond their shoulders' limits.</summary>
    private const float SteepestLeap = 17f;

    [Theory]
    [InlineData(11f, 5, Explicit = true)]
    [InlineData(-11f, 5, Explicit = true)]
    [InlineData(17f, 5)]
    [InlineData(-17f, 5)]
    [InlineData(20f, 5, Explicit = true)]
    [InlineData(-20f, 5, Explicit = true)]
    [InlineData(11f, 50, Explicit = true)]
    [InlineData(-11f, 50, Explicit = true)]
    [InlineData(17f, 50, Explicit = true)]
    [InlineData(-17f, 50, Explicit = true)]
    [InlineData(20f, 50, Explicit = true)]
    [InlineData(-20f, 50, Explicit = true)]
    public void Up_and_down_steady_slopes_all_gaits_keep_to_the_limits_of_all_joints_and_stand_on_the_ground(float degrees, int seeds)
    {
        FlatGround ground = Slope(degrees);
        for (ulong seed = 300; seed < 300 + (ulong)seeds; seed++)
        {
            var profile = new MotionProfile(Walkers.Any(seed));
            foreach (Movement movement in Movement.OfGoing(profile))
            {
                if (movement.Gait == null || (movement.Gait == GaitLibrary.Leap && Math.Abs(degrees) > SteepestLeap))
                {
                    continue;
                }

                CreatureAnimator animator = movement.Begin(profile, ground);
                Walkers.Run(animator, 3f, Rate, movement.Input, ground);
                MotionReport report = Walkers.Measure(animator, 45, Rate, movement.Input, ground);
                float leg = profile.LegLength;
                string name = $"{seed} {profile.Subject.Plan} {movement.GaitName}";
                Assert.True(report.LimitViolations == 0, $"{name}: {profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} beyond its limits by {report.LimitExcess}");
                Assert.True(report.MeanPenetration <= 0.004f * leg, $"{name}: sunk {report.MeanPenetration / leg} leg lengths");
                Assert.True(report.Slip <= 0.004f * leg, $"{name}: slip {report.Slip / leg} leg lengths");
            }
        }
    }

    /// <summary>The root kept to the ground under the middle of the feet, which stand ahead of the hips: up stairs that was a quarter of a leg too high.</summary>
    [Theory]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.ManyLegged)]
    [InlineData(BodyPlan.Sprawling, Explicit = true)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Unguligrade, Explicit = true)]
    public void Up_and_down_a_slope_the_root_is_on_the_ground_under_the_hips(BodyPlan plan)
    {
        foreach (float degrees in new[] { 17f, -17f })
        {
            FlatGround ground = Slope(degrees);
            var profile = new MotionProfile(Walkers.Of(plan, 300));
            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), ground);
            Walkers.Run(animator, 3f, Rate, new MotionInput(0.5f * profile.Gaits!.TopSpeed), ground);
            float away = 0f;
            foreach (LegRig leg in profile.Legs!.Legs)
            {
                Vector3 hip = animator.Root.ToWorld(new Vector3(leg.HipRest.X, 0f, leg.HipRest.Z));
                away += (hip.Y - (hip.Z * MathF.Tan(degrees * MathF.PI / 180f))) / profile.Legs.Legs.Length;
            }

            Assert.InRange(away / profile.LegLength, -0.06f, 0.06f);
        }
    }

    [Theory]
    [InlineData(17f, Explicit = true)]
    [InlineData(-17f)]
    public void A_run_stays_on_the_slope_at_any_speed(float degrees)
    {
        FlatGround ground = Slope(degrees);
        for (ulong seed = 300; seed < 340; seed++)
        {
            var profile = new MotionProfile(Walkers.Any(seed));
            if (profile.Gaits == null)
            {
                continue;
            }

            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), ground);
            Walkers.Run(animator, 3f, Rate, new MotionInput(profile.Gaits.TopSpeed), ground);
            for (int i = 0; i < 30; i++)
            {
                animator.Update(1f / Rate, new MotionInput(profile.Gaits.TopSpeed), ground);
                float above = Above(animator.Root.Position, degrees) / profile.LegLength;
                Assert.True(Math.Abs(above) < 0.12f, $"{seed}: the root is {above} leg lengths above the slope");
                for (int k = 0; k < animator.FootCount; k++)
                {
                    Assert.True(animator.Foot(k).Phase == FootPhase.Swing || Math.Abs(Above(animator.Foot(k).Place, degrees)) < 1e-3f * profile.LegLength, $"{seed}: foot {k} stands on air");
                }
            }
        }
    }

    [Fact]
    public void A_body_that_the_game_moves_along_a_slope_is_as_high_above_it_as_one_that_goes_by_itself()
    {
        foreach (ulong seed in new ulong[] { 304, 305, 306, 321, 340 })
        {
            var profile = new MotionProfile(Walkers.Any(seed));
            FlatGround ground = Slope(-17f);
            var own = new CreatureAnimator(profile);
            var moved = new CreatureAnimator(profile);
            own.Teleport(RootPlace.Identity, ground);
            moved.Teleport(RootPlace.Identity, ground);
            var input = new MotionInput(profile.Gaits!.Speeds[^1].Comfortable);
            double difference = 0;
            for (int i = 0; i < 150; i++)
            {
                own.Update(1f / Rate, input, ground);
                moved.Follow(1f / Rate, own.Root, ground);
                difference += i < 90 ? 0 : Pelvis(own) - Pelvis(moved);
            }

            Assert.True(Math.Abs(difference / 60) < 0.022f * profile.LegLength, $"{seed}: {difference / 60 / profile.LegLength} leg lengths apart");
        }
    }

    [Fact]
    public void The_longest_stance_is_that_of_the_level_and_never_longer_on_a_slope()
    {
        for (ulong seed = 300; seed < 330; seed++)
        {
            if (new MotionProfile(Walkers.Any(seed)).Legs is not LeggedBody body)
            {
                continue;
            }

            foreach (Gait gait in new[] { GaitLibrary.Walk, GaitLibrary.Trot, GaitLibrary.TransverseGallop })
            {
                SlopeStance stance = SlopeStance.Of(body, gait);
                Assert.Equal(SlopeStance.OnLevel(body, gait), stance.At(0f));
                float last = stance.At(0f);
                for (float slope = 0.05f; slope < 0.6f; slope += 0.05f)
                {
                    Assert.True(stance.At(slope) <= stance.At(slope - 0.05f) && stance.At(-slope) <= stance.At(0.05f - slope), $"{seed} {gait.Name} at {slope}");
                }

                Assert.True(last > 0f && stance.At(0.5f) > 0f && stance.At(-0.5f) > 0f);
            }
        }
    }

    [Fact]
    public void The_slope_is_felt_by_the_line_through_the_feet_and_not_at_all_where_they_are_level()
    {
        var feet = new Foot[4];
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i].Path.Start = feet[i].Path.End = new Vector3(i % 2, 0.3f, i - 1.5f);
        }

        GroundSlope slope = default;
        slope.Reset(feet, 1f);
        Assert.Equal(0f, slope.Rise, 6);
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i].Path.Start.Y = feet[i].Path.End.Y = 0.3f + (0.2f * feet[i].Path.Start.Z);
        }

        slope.Feel(feet, 1f, 0f, 0.1f);
        Assert.InRange(slope.Rise, 0.01f, 0.19f);
        for (int i = 0; i < 100; i++)
        {
            slope.Feel(feet, 1f, 0f, 0.1f);
        }

        Assert.Equal(0.2f, slope.Rise, 3);
    }

    [Fact]
    public void Feet_side_by_side_feel_the_slope_by_the_way_that_they_go_together()
    {
        var feet = new Foot[2];
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i].Path.Start = new Vector3(i, -0.3f, -1f);
            feet[i].Path.End = new Vector3(i, 0.3f, 1f);
        }

        GroundSlope slope = default;
        slope.Reset(feet, 1f);
        Assert.InRange(slope.Rise, 0.298f, 0.3f);
    }

    [Fact]
    public void A_slope_is_felt_the_sooner_the_faster_it_is_gone()
    {
        var level = new Foot[2];
        level[0].Path.Start = level[0].Path.End = new Vector3(0f, 0f, -1f);
        level[1].Path.Start = level[1].Path.End = new Vector3(0f, 0f, 1f);
        var steep = new Foot[2];
        steep[0].Path.Start = steep[0].Path.End = new Vector3(0f, -0.2f, -1f);
        steep[1].Path.Start = steep[1].Path.End = new Vector3(0f, 0.2f, 1f);
        GroundSlope slow = default;
        slow.Reset(level, 1f);
        GroundSlope fast = slow;
        slow.Feel(steep, 1f, 1f, 0.1f);
        fast.Feel(steep, 1f, 8f, 0.1f);
        Assert.InRange(slow.Rise, 0.02f, 0.9f * fast.Rise);
    }

    private static FlatGround Slope(float degrees) => new(Vector3.Zero, Vector3.Normalize(new Vector3(0f, 1f, -MathF.Tan(degrees * MathF.PI / 180f))));

    private static float Above(Vector3 point, float degrees) => point.Y - (point.Z * MathF.Tan(degrees * MathF.PI / 180f));

    private static float Pelvis(CreatureAnimator animator)
    {
        int joint = animator.Profile.Legs!.Trunk[0];
        return animator.Root.Position.Y + animator.ModelPose.Positions[joint].Y;
    }
}
