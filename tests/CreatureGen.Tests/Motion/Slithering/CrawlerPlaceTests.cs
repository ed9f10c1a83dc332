using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Slithering;

public sealed class CrawlerPlaceTests
{
    private const float Step = 1f / 60f;

    [Fact]
    public void A_sidewinder_carries_its_head_steadily_along_the_way_as_far_as_its_neck_reaches()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless, 20))
        {
            var profile = new MotionProfile(creature);
            Movement movement = Movement.Of(profile).Single(movement => movement.Crawl == SlitherGait.Sidewinding);
            CreatureAnimator animator = movement.Begin(profile, FlatGround.Level);
            double min = double.MaxValue;
            double max = double.MinValue;
            for (int i = 0; i < 480; i++)
            {
                animator.Update(Step, movement.Input, FlatGround.Level);
                if (i >= 240)
                {
                    double heading = Heading(animator, creature.Skeleton.IndexOf("Head"));
                    min = Math.Min(min, heading);
                    max = Math.Max(max, heading);
                }
            }

            string name = FormattableString.Invariant($"{creature.Blueprint.Seed}: {min} to {max}");
            Assert.True(max - min < 0.12, name);

            // The chest lies up to 2.1 rad across the way.
            double aside = Math.Max(0, 2.1 - (0.9 * profile.Slither!.NeckReach));
            Assert.True(min > -0.15 && max < aside + 0.15, name);
        }
    }

    [Fact]
    public void A_snake_that_has_not_moved_yet_lies_in_bends_about_its_root()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            var animator = new CreatureAnimator(creature);
            var place = new RootPlace(new Vector3(3f, 0f, -2f), Quaternion.Identity);
            animator.Teleport(place, FlatGround.Level);
            animator.Update(Step, default, FlatGround.Level);
            float length = new MotionProfile(creature).Slither!.BodyLength;
            Assert.True(Vec.Distance(place.Position, animator.Root.Position) < 0.002f * length);
            float[] sides = animator.ModelPose.Positions.ToArray().Select(at => at.X).ToArray();
            Assert.True(sides.Max() > 0.04f * length && sides.Min() < -0.04f * length, $"{creature.Blueprint.Seed}: {sides.Min()} to {sides.Max()} of {length}");
        }
    }

    /// <summary>Many heads have less than half a wave of the body behind them up to the root: their root jumped by up to 16 g.</summary>
    [Fact]
    public void The_root_of_a_crawler_goes_evenly_wherever_its_head_begins()
    {
        const float Fine = 1f / 120f;
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless, 12))
        {
            var animator = new CreatureAnimator(creature);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            Vector3 place = default;
            Vector3 velocity = default;
            for (int i = 0; i < 480; i++)
            {
                animator.Update(Fine, new MotionInput(creature.DefaultSpeed), FlatGround.Level);
                Vector3 now = (animator.Root.Position - place) / Fine;
                float hard = Vec.Distance(now, velocity) / Fine / 9.81f;
                Assert.True(i < 240 || hard < 0.5f, $"{creature.Blueprint.Seed}: {hard} g at a steady crawl");
                place = animator.Root.Position;
                velocity = now;
            }
        }
    }

    [Theory]
    [InlineData(0.04f)]
    [InlineData(-0.04f)]
    public void A_crawler_set_down_beside_the_height_of_its_ground_lies_on_it(float aside)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            var profile = new MotionProfile(creature);
            float length = profile.Slither!.BodyLength;
            IGround hills = new HillField(new Seed(1), 0.3f * length).Around(2f * length, -3f * length, 3f * length);
            Movement movement = Movement.Of(profile).Single(movement => movement.Name == "Slither");
            CreatureAnimator animator = movement.Begin(profile, hills);
            animator.Teleport(new RootPlace(new Vector3(0f, HeightAt(hills, Vector3.Zero) + (aside * length), 0f), Quaternion.Identity), hills);
            for (int i = 0; i < 60; i++)
            {
                animator.Update(Step, movement.Input, hills);
            }

            AssertOnGround(animator, hills, 0.03f * length);
        }
    }

    [Fact]
    public void A_root_that_the_game_holds_above_the_ground_lifts_the_body_no_further()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        var profile = new MotionProfile(creature);
        float length = profile.Slither!.BodyLength;
        var animator = new CreatureAnimator(profile);
        for (int i = 0; i < 300; i++)
        {
            float way = i * Step * profile.Slither.CruiseSpeed;
            animator.Follow(Step, new RootPlace(new Vector3(0f, 0.01f * length, way), Quaternion.Identity), FlatGround.Level);
        }

        AssertOnGround(animator, FlatGround.Level, 0.03f * length);
    }

    private static void AssertOnGround(CreatureAnimator animator, IGround ground, float tolerance)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        for (int j = 0; j < skeleton.Count; j++)
        {
            if (skeleton.Joints[j].Role is JointRole.Spine or JointRole.Pelvis or JointRole.Tail)
            {
                Vector3 place = animator.Root.ToWorld(animator.ModelPose.Positions[j]);
                float height = place.Y - HeightAt(ground, place);
                float rest = skeleton.ModelPositions[j].Y;
                Assert.True(Math.Abs(height - rest) < tolerance, FormattableString.Invariant($"{skeleton.Joints[j].Name} is {height} above the ground, at rest {rest}"));
            }
        }
    }

    private static float HeightAt(IGround ground, Vector3 place)
    {
        Assert.True(ground.Cast(new Vector3(place.X, 50f, place.Z), -Vector3.UnitY, 100f, out GroundHit hit));
        return hit.Point.Y;
    }

    private static double Heading(CreatureAnimator animator, int joint)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        Quaternion turn = Rotation.Multiply(animator.Root.Rotation, Rotation.Multiply(animator.ModelPose.Rotations[joint], Rotation.Inverse(skeleton.ModelRotations[joint])));
        Vector3 ahead = Rotation.Rotate(turn, Vector3.UnitZ);
        return PortableMath.Atan2(ahead.X, ahead.Z);
    }
}
