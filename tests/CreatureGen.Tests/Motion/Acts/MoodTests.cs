using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class MoodTests
{
    private const float Rate = 60f;

    [Theory]
    [InlineData(1f, 1f, 0.1f, 2f)]
    [InlineData(-1f, 1f, 0.03f, 1f)]
    [InlineData(1f, 0f, 0f, 0.02f)]
    [InlineData(1f, -1f, 0f, 0.02f)]
    public void Who_feels_well_wags_its_tail_and_others_do_not(float arousal, float valence, float least, float most)
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 1));
        var animator = new CreatureAnimator(profile) { Emotion = new Emotion(arousal, valence, 0f) };
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(animator.Root, FlatGround.Level);
        int tip = Array.FindLastIndex(profile.Subject.Skeleton.Joints.ToArray(), joint => joint.Role == JointRole.Tail);
        float left = float.MinValue;
        float right = float.MaxValue;
        for (int i = 0; i < 6f * Rate; i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
            float aside = animator.ModelPose.Positions[tip].X;
            left = i < Rate ? left : Math.Max(left, aside);
            right = i < Rate ? right : Math.Min(right, aside);
        }

        Assert.InRange((left - right) / profile.LegLength, least, most);
    }

    [Fact]
    public void Who_plays_lifts_its_feet_higher_as_it_walks_than_who_is_sad()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 1));
        float playful = Highest(new Emotion(1f, 1f, 0f));
        float neutral = Highest(default);
        float sad = Highest(new Emotion(-1f, -1f, 0f));
        Assert.InRange(playful / neutral, 1.3f, 2f);
        Assert.InRange(sad / neutral, 0.4f, 0.9f);

        float Highest(Emotion felt)
        {
            var animator = new CreatureAnimator(profile) { Emotion = felt };
            var input = new MotionInput(Movement.OfGoing(profile).First(movement => movement.Gait != null).Input.Speed);
            int ball = profile.Legs!.Legs[0].Ball;
            animator.Teleport(animator.Root, FlatGround.Level);
            float stood = animator.ModelPose.Positions[ball].Y;
            float highest = 0f;
            for (int i = 0; i < 5f * Rate; i++)
            {
                animator.Update(1f / Rate, input, FlatGround.Level);
                highest = i < 2f * Rate ? 0f : Math.Max(highest, animator.ModelPose.Positions[ball].Y - stood);
            }

            return highest;
        }
    }
}
