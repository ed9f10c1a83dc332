using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class PerformingTests
{
    private static readonly MotionProfile dog = new(Walkers.Of(BodyPlan.Digitigrade, 5));

    [Fact]
    public void An_unknown_act_is_refused_with_a_list_of_all()
    {
        var problem = Assert.Throws<ArgumentException>(() => new CreatureAnimator(dog).Perform("juggle"));

        Assert.Contains("\"juggle\" is no act; expected one of Bite, ", problem.Message, StringComparison.Ordinal);
        Assert.Contains("Sleep", problem.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(float.NaN, 0f, 1f)]
    [InlineData(0f, float.PositiveInfinity, 1f)]
    [InlineData(0f, 0f, 1e13f)]
    public void A_target_that_is_no_place_is_refused(float x, float y, float z) => Assert.ThrowsAny<ArgumentException>(() => ActTarget.At(new Vector3(x, y, z)));

    [Fact]
    public void What_a_body_lacks_is_said_and_nothing_begins()
    {
        var animator = new CreatureAnimator(new MotionProfile(Walkers.Of(BodyPlan.Legless, 5)));

        ActStart start = animator.Perform("Kick");

        Assert.Equal(ActStatus.Refused, start.Status);
        Assert.Equal("it is not for a body that is on its belly", start.Reason);
        Assert.Null(animator.Act);
    }

    [Fact]
    public void A_target_out_of_reach_is_refused_with_how_far_it_would_be_missed()
    {
        var animator = new CreatureAnimator(dog);

        ActStart start = animator.Perform("Bite", ActTarget.At(new Vector3(0f, 1f, 40f)));

        Assert.Equal(ActStatus.OutOfReach, start.Status);
        Assert.InRange(start.Missing, 30f, 40f);
        Assert.Null(animator.Act);
    }

    [Fact]
    public void A_contact_is_told_once_at_the_time_that_was_published_and_at_the_target()
    {
        var animator = new CreatureAnimator(dog);
        float reach = dog.LegLength;
        Vector3 target = new(0.1f * reach, 1.2f * reach, animator.Acts.Find("bite").Reach!.Value.Nearest + (0.2f * reach));
        float contact = animator.Perform("Bite", ActTarget.At(target)).SecondsToContact!.Value;
        var told = new List<(double At, ActEvent Event)>();
        double time = 0;
        for (int i = 0; i < 900; i++)
        {
            animator.Update(1f / 240f, default, FlatGround.Level);
            time += 1.0 / 240;
            foreach (ActEvent item in animator.ActEvents)
            {
                told.Add((time - item.SecondsAgo, item));
            }
        }

        (double at, ActEvent bite) = Assert.Single(told, item => item.Event.Mark == ActMark.Contact);
        Assert.Equal(contact, at, 2e-3);
        Assert.InRange(Vector3.Distance(bite.Position, target), 0f, 0.03f * reach);
        Assert.Equal([ActMark.Begin, ActMark.Commit, ActMark.Contact, ActMark.End], told.Select(item => item.Event.Mark));
        Assert.Null(animator.Act);
    }

    [Fact]
    public void Acts_and_updates_allocate_nothing_after_the_first()
    {
        var animator = new CreatureAnimator(dog);
        ActAbility[] acts = animator.Acts.Possible.ToArray();
        animator.Perform(acts[0]);

        Assert.Equal(0, MovingPose.Allocated(Go, 1));

        void Go()
        {
            foreach (ActAbility act in acts)
            {
                animator.Perform(act);
                Walkers.Run(animator, 0.8f, 60f, new MotionInput(1f), FlatGround.Level);
                animator.GoOn();
                Walkers.Run(animator, 0.3f, 60f, default, FlatGround.Level);
            }
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod, Explicit = true)]
    [InlineData(BodyPlan.Hexapod, Explicit = true)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Fish)]
    public void An_act_that_is_over_leaves_no_trace(BodyPlan plan)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 5));
        var acting = new CreatureAnimator(profile);
        var plain = new CreatureAnimator(profile);
        ActAbility call = acting.Acts.Find("Sniff") is { IsPossible: true } sniff ? sniff : acting.Acts.Possible.First();
        acting.Perform(call);
        for (int i = 0; i < 60 * 12; i++)
        {
            acting.Update(1f / 60f, default, FlatGround.Level);
            plain.Update(1f / 60f, default, FlatGround.Level);
        }

        Assert.Null(acting.Act);
        for (int i = 0; i < profile.Subject.Skeleton.Count; i++)
        {
            double apart = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(plain.LocalPose.Rotations[i]), acting.LocalPose.Rotations[i]));
            Assert.True(apart < 0.02, $"{profile.Subject.Skeleton.Joints[i].Name}: {apart}");
        }
    }

    [Fact]
    public void An_act_that_is_broken_off_at_any_moment_goes_over_without_a_jump()
    {
        var animator = new CreatureAnimator(dog);
        ActAbility[] acts = animator.Acts.Possible.ToArray();
        animator.Teleport(animator.Root, FlatGround.Level);
        Vector3[] before = animator.ModelPose.Positions.ToArray();
        var fastest = (LegsPerSecond: 0f, Joint: "", Act: "", Phase: "");
        for (int i = 0; i < 2400; i++)
        {
            if (i % 47 == 0)
            {
                animator.Perform(acts[i / 47 % acts.Length]);
            }

            if (i % 331 == 330)
            {
                animator.StopAct();
            }

            animator.Update(1f / 240f, default, FlatGround.Level);
            for (int joint = 0; joint < before.Length; joint++)
            {
                float speed = Vector3.Distance(before[joint], animator.ModelPose.Positions[joint]) * 240f / dog.LegLength;
                fastest = speed > fastest.LegsPerSecond ? (speed, dog.Subject.Skeleton.Joints[joint].Name, animator.Act?.Name ?? "", animator.ActPhase?.Name ?? "") : fastest;
            }

            animator.ModelPose.Positions.CopyTo(before);
        }

        Assert.True(fastest.LegsPerSecond < 12f, fastest.ToString());
    }

    /// <summary>Its head let go of the target of the act before, and flew there and back: an eel's at 125 rad/s.</summary>
    [Theory]
    [InlineData(RequestedKind.Swimming, 10600005UL)]
    [InlineData(RequestedKind.Swimming, 10600006UL)]
    [InlineData(RequestedKind.Walking, 42UL)]
    public void A_bite_that_is_broken_off_lets_go_of_its_target_without_a_jump(RequestedKind kind, ulong seed)
    {
        const float FastestHead = 20f;
        var animator = new CreatureAnimator(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        int head = animator.Profile.Subject.Skeleton.FirstOf(JointRole.Head);
        Assert.Equal(ActStatus.Started, animator.Perform("Bite").Status);
        int frames = 0;
        while (!animator.ActEvents.ToArray().Any(e => e.Mark == ActMark.Contact) && frames++ < 600)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
        }

        Quaternion before = animator.LocalPose.Rotations[head];
        animator.StopAct();
        for (int i = 0; i < 60; i++)
        {
            animator.Update(1f / 60f, default, FlatGround.Level);
            Quaternion now = animator.LocalPose.Rotations[head];
            double speed = 60 * Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before), now));
            Assert.True(speed < FastestHead, $"{speed} rad/s, {i} updates after it was broken off");
            before = now;
        }
    }

    [Fact]
    public void A_creature_that_goes_stops_for_an_act_on_the_spot_and_goes_on_afterwards()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 2f, 60f, new MotionInput(1.2f), FlatGround.Level);
        animator.Perform("Threaten");
        Assert.Null(animator.ActPhase);
        Walkers.Run(animator, 2.5f, 60f, new MotionInput(1.2f), FlatGround.Level);
        Assert.NotNull(animator.ActPhase);
        Assert.InRange(animator.Speed, -0.02f, 0.02f);
        Walkers.Run(animator, 8f, 60f, new MotionInput(1.2f), FlatGround.Level);
        Assert.Null(animator.Act);
        Assert.InRange(animator.Speed, 1f, 1.4f);
    }

    [Fact]
    public void A_call_goes_on_at_a_walk()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 2f, 60f, new MotionInput(1.2f), FlatGround.Level);
        animator.Perform("Call");
        Walkers.Run(animator, 0.5f, 60f, new MotionInput(1.2f), FlatGround.Level);

        Assert.NotNull(animator.ActPhase);
        Assert.InRange(animator.Speed, 1f, 1.4f);
    }

    [Fact]
    public void What_lasts_lasts_until_it_is_told_to_go_on()
    {
        var animator = new CreatureAnimator(dog);
        ActAbility lie = animator.Acts.Find("Lie");
        animator.Perform(lie);
        Walkers.Run(animator, lie.Seconds + 20f, 30f, default, FlatGround.Level);
        Assert.Equal("lie", animator.ActPhase?.Name);
        animator.GoOn();
        Walkers.Run(animator, lie.Seconds, 30f, default, FlatGround.Level);
        Assert.Null(animator.Act);
    }

    [Fact]
    public void Fear_crouches_and_a_threat_does_not_and_calm_is_as_before()
    {
        Vector3 calm = PelvisOf(default);
        Vector3 fear = PelvisOf(new Emotion(1f, -1f, -1f));
        Vector3 threat = PelvisOf(new Emotion(1f, -1f, 1f));
        Assert.True(fear.Y < calm.Y - (0.1f * dog.LegLength), $"{fear} {calm}");
        Assert.True(threat.Y > calm.Y - (0.1f * dog.LegLength) && threat.Z > fear.Z, $"{threat} {fear}");
        Assert.ThrowsAny<ArgumentException>(() => new CreatureAnimator(dog).Emotion = new Emotion(float.NaN, 0f, 0f));

        static Vector3 PelvisOf(Emotion emotion)
        {
            var animator = new CreatureAnimator(dog) { Emotion = emotion };
            Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
            return animator.ModelPose.Positions[dog.Subject.Skeleton.IndexOf("Pelvis")];
        }
    }

    [Fact]
    public void The_same_acts_give_the_same_bits()
    {
        Quaternion[] first = Play();
        Assert.Equal(first, Play());

        static Quaternion[] Play()
        {
            var animator = new CreatureAnimator(new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5)));
            animator.Perform("Eat");
            Walkers.Run(animator, 1.3f, 60f, default, FlatGround.Level);
            animator.Perform("Bite");
            Walkers.Run(animator, 0.7f, 37f, default, FlatGround.Level);
            return animator.LocalPose.Rotations.ToArray();
        }
    }

    [Fact]
    public void A_ground_that_throws_undoes_an_act_s_update()
    {
        var animator = new CreatureAnimator(dog);
        animator.Perform("Call");
        Walkers.Run(animator, 0.5f, 60f, default, FlatGround.Level);
        ActPhase? phase = animator.ActPhase;
        Assert.Throws<InvalidOperationException>(() => animator.Update(0.25f, new MotionInput(1f), new Throwing()));
        Assert.Same(phase, animator.ActPhase);
    }

    private sealed class Throwing : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float length, out GroundHit hit) => throw new InvalidOperationException("no ground today");
    }
}
