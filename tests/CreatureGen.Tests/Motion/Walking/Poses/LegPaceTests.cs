using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Poses;

/// <summary>Legs turn by no more than nature does, whatever is asked of them.</summary>
public sealed class LegPaceTests
{
    private const float Rate = 480f;

    /// <summary>Feet that are asked to be high one moment and low the next: several hundred radians per second without a bound.</summary>
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Sprawling)]
    [InlineData(BodyPlan.Theropod)]
    public void Joints_of_legs_keep_to_their_pace_however_feet_are_thrown_about(BodyPlan plan)
    {
        float fastest = Fastest(plan, frame => 4f * (frame / 8 % 2));
        Assert.InRange(fastest, 40f, 58.5f);
    }

    [Fact]
    public void What_is_slow_enough_is_not_slowed_down() => Assert.InRange(Fastest(BodyPlan.Digitigrade, _ => 1f), 5f, 40f);

    /// <summary>After it has been thrown about a foot is where one is that has not: it lags for a moment only.</summary>
    [Fact]
    public void A_leg_that_lagged_is_soon_where_it_should_be()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 3));
        var thrown = new CreatureAnimator(profile);
        var calm = new CreatureAnimator(profile);
        var input = new MotionInput(0.5f * profile.Gaits!.TopSpeed);
        for (int frame = 0; frame < 960; frame++)
        {
            Lift(thrown, frame < 480 ? 4f * (frame / 8 % 2) : 1f);
            thrown.Update(1f / Rate, input, FlatGround.Level);
            calm.Update(1f / Rate, input, FlatGround.Level);
        }

        for (int i = 0; i < thrown.FootCount; i++)
        {
            Assert.True(Vector3.Distance(thrown.ModelPose.Positions[thrown.Foot(i).Joint], calm.ModelPose.Positions[calm.Foot(i).Joint]) < 0.02f * profile.LegLength);
        }
    }

    private static float Fastest(BodyPlan plan, Func<int, float> lift)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 3));
        var animator = new CreatureAnimator(profile);
        var input = new MotionInput(0.5f * profile.Gaits!.TopSpeed);
        int[] joints = Enumerable.Range(0, profile.Subject.Skeleton.Count).Where(j => profile.Subject.Skeleton.Joints[j].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball).ToArray();
        var before = new Quaternion[joints.Length];
        double fastest = 0;
        for (int frame = 0; frame < 960; frame++)
        {
            Lift(animator, lift(frame));
            animator.Update(1f / Rate, input, FlatGround.Level);
            for (int i = 0; i < joints.Length; i++)
            {
                Quaternion now = animator.LocalPose.Rotations[joints[i]];
                fastest = frame > 0 ? Math.Max(fastest, Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[i]), now)) * Rate) : fastest;
                before[i] = now;
            }
        }

        return (float)fastest;
    }

    private static void Lift(CreatureAnimator animator, float lift)
    {
        MotionSettings settings = animator.Settings;
        settings.Walking = settings.Walking with { Lift = lift };
        animator.Settings = settings;
    }
}
