using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

/// <summary>How bodies carry themselves in moods and acts that need no face: tall or low, and hips before the tail.</summary>
public class CarriageTests
{
    private const float Rate = 60f;

    [Theory]
    [InlineData(BodyPlan.Hexapod, 1)]
    [InlineData(BodyPlan.Hexapod, 2)]
    [InlineData(BodyPlan.ManyLegged, 1)]
    [InlineData(BodyPlan.ManyLegged, 3)]
    public void Many_legged_bodies_stand_tall_when_they_threaten_and_low_when_they_are_sad_on_feet_that_stay(BodyPlan plan, ulong seed)
    {
        var profile = new MotionProfile(Walkers.Of(plan, seed));
        float neutral = ChestHeight(default);
        float threat = ChestHeight(new Emotion(1f, -1f, 1f));
        float sad = ChestHeight(new Emotion(-1f, -1f, 0f));
        Assert.True(threat > neutral && sad < 0.9f * neutral, FormattableString.Invariant($"{threat}, {neutral} and {sad} m"));

        float ChestHeight(Emotion emotion)
        {
            CreatureAnimator animator = Standing(profile);
            animator.Emotion = emotion;
            Vector3[] stood = Balls(animator);
            Walkers.Run(animator, 3f, Rate, default, FlatGround.Level);
            Assert.All(Balls(animator).Zip(stood), ball => Assert.InRange(Vector3.Distance(ball.First, ball.Second) / profile.LegLength, 0f, 0.01f));
            return animator.ModelPose.Positions[profile.Acts.Body.Spine[^1]].Y;
        }

        Vector3[] Balls(CreatureAnimator animator) => [.. profile.Legs!.Legs.Select(leg => animator.ModelPose.Positions[leg.Ball])];
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void In_a_sweep_the_hips_turn_before_the_end_of_the_tail_comes_over(ulong seed)
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Theropod, seed));
        float swept = TipAsideAfter("sweep");
        float hit = TipAsideAfter("hit");
        Assert.True(swept * hit < 0f, FormattableString.Invariant($"{swept} and {hit} m"));

        // Of the root of the tail, as the hips see it.
        float TipAsideAfter(string phase)
        {
            CreatureAnimator of = Standing(profile);
            GoTo(of, "TailSweep", of.Acts.Find("TailSweep").Act.Phases.ToList().FindIndex(one => one.Name == phase));
            Skeleton skeleton = profile.Subject.Skeleton;
            int hips = skeleton.FirstOf(JointRole.Pelvis);
            int[] tail = profile.Acts.Body.Tail.Joints;
            Quaternion turn = Rotation.Multiply(skeleton.ModelRotations[hips], Rotation.Inverse(of.ModelPose.Rotations[hips]));
            return Rotation.Rotate(turn, of.ModelPose.Positions[tail[^1]] - of.ModelPose.Positions[tail[0]]).X;
        }
    }

    private static CreatureAnimator Standing(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(animator.Root, FlatGround.Level);
        return animator;
    }

    /// <summary>Performs an act up to the end of a phase.</summary>
    private static void GoTo(CreatureAnimator animator, string act, int phase)
    {
        ActAbility ability = animator.Acts.Find(act);
        Assert.True(ability.IsPossible, ability.Refusal);
        animator.Perform(ability);
        Walkers.Run(animator, ability.SecondsTo(phase), Rate, default, FlatGround.Level);
    }
}
