using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>Fliers without legs: nothing to stand on.</summary>
public sealed class LeglessFlierTests
{
    private const float Step = 1f / 60f;

    public static TheoryData<ulong> Seeds => [1, 2, 3, 4, 5, 6];

    [Theory]
    [MemberData(nameof(Seeds))]
    public void A_flier_without_legs_beats_its_wings_and_comes_off_the_ground_when_nothing_is_asked_of_it(ulong seed)
    {
        var animator = new CreatureAnimator(Grown(seed));
        int beats = 0;
        for (int i = 0; i < 600; i++)
        {
            animator.Update(Step, default, FlatGround.Level);
            beats += animator.Events.ToArray().Count(e => e.Kind == MotionEventKind.WingBeat);
        }

        Assert.InRange(beats, 8 * animator.Frequency, 11 * animator.Frequency);
        Assert.False(animator.StandsOnFeet);
        Assert.InRange(animator.Root.Position.Y / animator.Profile.Flight!.LegLength, 1.1f, 1.7f);
        Assert.InRange(animator.Root.Position.X, -1e-3f, 1e-3f);
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void A_flier_without_legs_stays_where_it_hangs_at_rest(ulong seed)
    {
        var animator = new CreatureAnimator(Grown(seed));
        animator.Teleport(new RootPlace(new Vector3(0f, 50f, 0f), Quaternion.Identity), FlatGround.Level);
        for (int i = 0; i < 600; i++)
        {
            animator.Update(Step, default, FlatGround.Level);
        }

        Assert.Equal(new Vector3(0f, 50f, 0f), animator.Root.Position);
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void The_idle_of_a_flier_without_legs_is_its_hover(ulong seed)
    {
        Creature creature = Grown(seed);
        IReadOnlyList<Movement> movements = Movement.OfGoing(new MotionProfile(creature));
        Movement idle = movements.Single(movement => movement.Name == "Idle");
        Assert.Equal(movements.Single(movement => movement.Name == "Hover").Input, idle.Input);
        Assert.True(idle.IsCyclic);
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void A_flier_without_legs_darts_ahead_to_bite_and_dances_from_side_to_side_while_its_wings_beat(ulong seed)
    {
        var animator = new CreatureAnimator(Grown(seed));
        int body = animator.Profile.Subject.Skeleton.FirstOf(JointRole.Body);
        float[] along = animator.Profile.Subject.Skeleton.ModelPositions.ToArray().Select(place => place.Z).ToArray();
        float length = along.Max() - along.Min();
        Vector3 bite = Way("Bite");
        Vector3 dance = Way("Dance");
        Assert.True(bite.Z > 0.2f * length, $"{bite} of {length}");
        Assert.True(dance.X > 0.2f * length, $"{dance} of {length}");

        // How far the body goes to and fro in an act.
        Vector3 Way(string act)
        {
            Assert.Equal(ActStatus.Started, animator.Perform(act).Status);
            ActAbility ability = animator.Acts.Find(act);
            var low = new Vector3(float.MaxValue);
            Vector3 high = -low;
            int beats = 0;
            for (float seconds = 0f; seconds < ability.Seconds; seconds += Step)
            {
                animator.Update(Step, default, FlatGround.Level);
                beats += animator.Events.ToArray().Count(e => e.Kind == MotionEventKind.WingBeat);
                low = Vector3.Min(low, animator.ModelPose.Positions[body]);
                high = Vector3.Max(high, animator.ModelPose.Positions[body]);
            }

            Assert.True(beats >= (int)(0.7f * ability.Seconds * animator.Frequency), $"{act}: {beats} beats");
            return high - low;
        }
    }

    private static Creature Grown(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, MinLegPairs = 0, MaxLegPairs = 0 });
        Assert.DoesNotContain(creature.Limbs, limb => limb.Kind == LimbKind.Leg);
        return creature;
    }
}
