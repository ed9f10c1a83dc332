using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

/// <summary>A game's own flat ground is walked on as the library's.</summary>
public sealed class OwnGroundTests
{
    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Hexapod)]
    public void A_ground_that_promises_to_be_a_plane_is_walked_on_to_the_bit_as_a_flat_one_and_without_the_promise_the_same_but_for_rounding(BodyPlan plan)
    {
        Creature creature = Walkers.Of(plan, 2);
        Vector3[] flat = Walked(creature, FlatGround.Level);
        Assert.Equal(flat, Walked(creature, new OwnPlane()));
        Vector3[] felt = Walked(creature, new OwnFloor());
        float worst = 0f;
        for (int i = 0; i < flat.Length; i++)
        {
            worst = Math.Max(worst, Vector3.Distance(flat[i], felt[i]));
        }

        Assert.True(worst < 1e-4f, FormattableString.Invariant($"{worst} m"));
    }

    private static Vector3[] Walked(Creature creature, IGround ground)
    {
        var animator = new CreatureAnimator(creature);
        var places = new Vector3[240 * creature.Skeleton.Count];
        for (int i = 0; i < 240; i++)
        {
            animator.Update(1f / 60f, new MotionInput(creature.DefaultSpeed, i < 120 ? 0f : 0.5f), ground);
            for (int j = 0; j < creature.Skeleton.Count; j++)
            {
                places[(i * creature.Skeleton.Count) + j] = animator.Root.ToWorld(animator.ModelPose.Positions[j]);
            }
        }

        return places;
    }

    private class OwnFloor : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit) => FlatGround.Level.Cast(origin, direction, distance, out hit);
    }

    private sealed class OwnPlane : OwnFloor, IPlaneGround
    {
        public Vector3 Normal => Vector3.UnitY;
    }
}
