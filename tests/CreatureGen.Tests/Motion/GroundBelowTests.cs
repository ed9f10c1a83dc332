using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Swimmers and fliers over ground that rises and falls away.</summary>
public sealed class GroundBelowTests
{
    private const float Step = 1f / 60f;

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Whale)]
    [InlineData(BodyPlan.Eel)]
    public void A_swimmer_that_is_told_to_dive_keeps_above_the_ground_and_rises_with_it(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            var bed = new Heights(z => 0.25f * Math.Max(z - 6f, 0f));
            var animator = new CreatureAnimator(creature);
            animator.Teleport(new RootPlace(new Vector3(0f, 4f, 0f), Quaternion.Identity), bed);
            float deepest = float.MaxValue;
            float hardest = 0f;
            Vector3 velocity = default;
            for (int i = 0; i < 1200; i++)
            {
                Vector3 before = animator.Root.Position;
                animator.Update(Step, new MotionInput(creature.DefaultSpeed, ClimbRate: -0.5f * creature.DefaultSpeed), bed);
                Vector3 now = (animator.Root.Position - before) / Step;
                hardest = i == 0 ? 0f : Math.Max(hardest, Vector3.Distance(now, velocity) / Step / 9.81f);
                velocity = now;
                deepest = Math.Min(deepest, animator.Root.Position.Y - bed.At(animator.Root.Position.Z));
            }

            Assert.True(deepest > -1e-3f, $"{creature.Blueprint.Seed}: {deepest} m above the bed");
            Assert.True(animator.Root.Position.Z > 10f && animator.Root.Position.Y > 1f, $"{creature.Blueprint.Seed}: {animator.Root.Position}");
            Assert.True(hardest < 1f, $"{creature.Blueprint.Seed}: {hardest} g");
        }
    }

    [Fact]
    public void A_flier_that_walks_off_a_cliff_takes_to_its_wings_and_lands_below()
    {
        int fell = 0;
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Flapping, 8).Where(creature => creature.Blueprint.Legs.Count > 0))
        {
            var profile = new MotionProfile(creature);
            if (profile.Gaits == null)
            {
                continue;
            }

            var cliff = new Heights(z => z < 1.5f ? 0f : -15f);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, cliff);
            float walk = profile.Gaits.Speeds[0].Comfortable;
            int flying = 0;
            int landed = -1;
            for (int i = 0; i < 1800 && landed < 0; i++)
            {
                animator.Update(Step, new MotionInput(walk), cliff);
                flying += animator.StandsOnFeet ? 0 : 1;
                landed = flying > 30 && animator.StandsOnFeet ? i : -1;
            }

            Assert.True(landed > 0, $"{creature.Blueprint.Seed}: at {animator.Root.Position}, {flying} updates in the air");
            Assert.Equal(-15f, animator.Root.Position.Y, 0.1f * profile.LegLength);
            fell++;
        }

        Assert.True(fell > 3);
    }

    /// <summary>Ground whose height depends on how far ahead it is.</summary>
    private sealed class Heights(Func<float, float> height) : IGround
    {
        public float At(float z) => height(z);

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            // Rays of creatures go down, or nearly so.
            float down = -direction.Y;
            float floor = height(origin.Z);
            hit = default;
            if (down < 0.5f || (origin.Y - floor) / down > distance || origin.Y < floor)
            {
                return false;
            }

            hit = new GroundHit(origin + (direction * ((origin.Y - floor) / down)), Vector3.UnitY);
            return true;
        }
    }
}
