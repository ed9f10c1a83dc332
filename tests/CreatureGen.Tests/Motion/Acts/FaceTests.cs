using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class FaceTests
{
    private static readonly MotionProfile dog = new(Walkers.Of(BodyPlan.Digitigrade, 5));

    [Fact]
    public void Who_sleeps_has_its_eyes_shut_and_who_wakes_opens_them()
    {
        var animator = new CreatureAnimator(dog);
        ActAbility sleep = animator.Acts.Find("Sleep");
        animator.Perform(sleep);
        Walkers.Run(animator, sleep.SecondsToLast + 3f, 30f, default, FlatGround.Level);
        Assert.Equal("sleep", animator.ActPhase?.Name);
        Assert.InRange(Shut(animator), 0.95f, 1.001f);
        animator.GoOn();
        Walkers.Run(animator, sleep.Seconds + 1f, 30f, default, FlatGround.Level);
        Assert.InRange(WidestOf(animator, 40), -0.01f, 0.01f);
    }

    [Fact]
    public void Lids_show_what_is_felt()
    {
        float sad = Felt(new Emotion(-1f, -1f, 0f));
        float threat = Felt(new Emotion(1f, -1f, 1f));
        float fear = Felt(new Emotion(1f, -1f, -1f));
        Assert.InRange(sad, 0.4f, 0.8f);
        Assert.InRange(threat, 0.15f, 0.4f);
        Assert.True(fear < 0f, FormattableString.Invariant($"{fear}"));

        static float Felt(Emotion emotion)
        {
            var animator = new CreatureAnimator(dog) { Emotion = emotion };
            Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
            return WidestOf(animator, 40);
        }
    }

    [Theory]
    [InlineData(9999018)]
    [InlineData(9999043)]
    [InlineData(9999045, Explicit = true)]
    public void Feelers_are_laid_back_in_fear(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Skeleton skeleton = profile.Subject.Skeleton;
        int[] feeler = profile.Acts.Body.Feelers[0].Joints;
        int head = skeleton.FirstOf(JointRole.Head);
        float calm = Up(default);
        float afraid = Up(new Emotion(1f, -1f, -1f));
        Assert.True(afraid > calm + (0.03f * profile.Acts.Body.Feelers[0].Length), FormattableString.Invariant($"a feeler is {calm} m above its root in calm, {afraid} m in fear"));

        // As the head sees it.
        float Up(Emotion emotion)
        {
            var animator = new CreatureAnimator(profile) { Emotion = emotion };
            Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
            Pose model = animator.ModelPose;
            Quaternion level = Rotation.Multiply(skeleton.ModelRotations[head], Rotation.Inverse(model.Rotations[head]));
            return Rotation.Rotate(level, model.Positions[feeler[^1]] - model.Positions[feeler[0]]).Y;
        }
    }

    [Fact]
    public void Eyes_of_what_is_limp_sink_shut_and_do_not_blink()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 0.5f, 60f, default, FlatGround.Level);
        animator.GoLimp();
        Walkers.Run(animator, 4f, 60f, default, FlatGround.Level);
        for (int i = 0; i < 300; i++)
        {
            animator.Update(1f / 30f, default, FlatGround.Level);
            Assert.InRange(Shut(animator), 0.8f, 0.9f);
        }
    }

    [Fact]
    public void A_feeling_shows_at_once_after_a_jump_to_another_place()
    {
        var animator = new CreatureAnimator(dog) { Emotion = new Emotion(1f, -1f, -1f) };
        Walkers.Run(animator, 4f, 60f, default, FlatGround.Level);
        Vector3 crouched = Pelvis(animator);
        animator.Teleport(new RootPlace(new Vector3(9f, 0f, 4f), Quaternion.Identity), FlatGround.Level);
        Assert.InRange(Pelvis(animator).Y / crouched.Y, 0.97f, 1.03f);
        Walkers.Run(animator, 0.2f, 60f, default, FlatGround.Level);
        Assert.InRange(Pelvis(animator).Y / crouched.Y, 0.97f, 1.03f);

        static Vector3 Pelvis(CreatureAnimator animator) => animator.ModelPose.Positions[dog.Subject.Skeleton.IndexOf("Pelvis")];
    }

    [Theory]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Buzzing)]
    public void Wings_are_spread_in_a_threat_and_fold_again(BodyPlan plan)
    {
        Creature creature = CreatureGenerator.Generate(5, CreatureOptions.Default with { Kind = RequestedKind.Flying, BodyPlans = BodyPlanWeight.Only(plan), Strangeness = 0 });
        var profile = new MotionProfile(creature);
        ActAbility threat = profile.Acts.Find("Threaten");
        Assert.True(threat.IsPossible, threat.Refusal);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        float folded = Span(animator);
        animator.Perform(threat);
        float widest = 0f;
        for (int i = 0; i < threat.Seconds * 60; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            widest = Math.Max(widest, Span(animator));
        }

        Walkers.Run(animator, 2f, 60f, default, FlatGround.Level);
        Assert.True(widest > 1.3f * folded, FormattableString.Invariant($"{widest} of {folded}"));
        Assert.InRange(Span(animator) / folded, 0.98f, 1.02f);

        float Span(CreatureAnimator of) => profile.Subject.Skeleton.Joints.Select((joint, i) => joint.Role == JointRole.Wing ? of.ModelPose.Positions[i].X : 0f).Max();
    }

    [Fact]
    public void Movements_list_all_ways_of_going_and_then_all_acts()
    {
        string[] going = Movement.OfGoing(dog).Select(movement => movement.Name).ToArray();
        Movement[] all = Movement.Of(dog).ToArray();
        Assert.Equal(going, all.Where(movement => movement.Act == null).Select(movement => movement.Name));
        Assert.Equal(dog.Acts.Possible, all.Where(movement => movement.Kind == ClipKind.Act).Select(movement => movement.Act));
    }

    /// <summary>Most open that lids are in some updates: blinks do not count.</summary>
    private static float WidestOf(CreatureAnimator animator, int updates)
    {
        float least = 1f;
        for (int i = 0; i < updates; i++)
        {
            animator.Update(1f / 30f, default, FlatGround.Level);
            least = Math.Min(least, Shut(animator));
        }

        return least;
    }

    private static float Shut(CreatureAnimator animator)
    {
        Eyelids lids = Eyelids.Of(dog.Subject.Skeleton)!;
        Joint joint = dog.Subject.Skeleton.Joints[lids.Joints[0]];
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), animator.LocalPose.Rotations[lids.Joints[0]]);
        AngleRange range = joint.Limit.SwingX;
        float closing = range.Max > -range.Min ? range.Max : range.Min;
        return 2f * MathF.Atan2(turn.X, turn.W) / closing;
    }
}
