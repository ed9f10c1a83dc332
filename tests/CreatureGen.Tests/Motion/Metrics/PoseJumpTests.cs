using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics;

public sealed class PoseJumpTests
{
    /// <summary>Walkers that jumped: legs that gave way at once as a hop landed, tails and ears that whipped as a hop landed or a foot came down, toes thrown up at the end of a stance, knees of columns that snapped as another leg drew the body down, crawlers off the edge of their hills or beside their height.</summary>
    [Theory]
    [InlineData(255, "Hop", GroundRelief.Flat)]
    [InlineData(255, "Hop", GroundRelief.Rough, Explicit = true)]
    [InlineData(2092, "Hop", GroundRelief.Flat, Explicit = true)]
    [InlineData(2137, "Hop", GroundRelief.Flat, Explicit = true)]
    [InlineData(7019, "Hop", GroundRelief.Flat, Explicit = true)]
    [InlineData(7123, "Hop", GroundRelief.Flat, Explicit = true)]
    [InlineData(7123, "Hop", GroundRelief.Rough, Explicit = true)]
    [InlineData(5035, "Hop", GroundRelief.Flat, Explicit = true)]
    [InlineData(135, "BipedRun", GroundRelief.Flat, Explicit = true)]
    [InlineData(135, "BipedWalk", GroundRelief.Rough)]
    [InlineData(278, "Walk", GroundRelief.Rough, Explicit = true)]
    [InlineData(278, "Canter", GroundRelief.Rough, Explicit = true)]
    [InlineData(41, "Trot", GroundRelief.Flat)]
    [InlineData(66, "Trot", GroundRelief.Rough, Explicit = true)]
    [InlineData(90, "Trot", GroundRelief.Flat, Explicit = true)]
    [InlineData(101, "Walk", GroundRelief.Rough, Explicit = true)]
    [InlineData(114, "Walk", GroundRelief.Rough, Explicit = true)]
    [InlineData(43, "Sidewind", GroundRelief.Rough)]
    [InlineData(43, "Rectilinear", GroundRelief.Rough, Explicit = true)]
    [InlineData(298, "Rectilinear", GroundRelief.Rough, Explicit = true)]
    public void No_pose_changes_three_times_as_fast_as_usual(int seed, string gait, GroundRelief relief)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        Movement movement = Movement.Of(profile).Single(movement => movement.GaitName == gait);
        foreach (float rate in new[] { 30f, 60f, 144f })
        {
            MotionReport report = new MotionTrial(movement, relief, rate).Run(profile);
            Assert.True(report.PoseJump <= 3f, $"{rate} Hz: {report.PoseJump}");
        }
    }

    /// <summary>Fliers that jumped: wrists thrown back in the upstroke of those that glide between beats, and a tail pushed up by the ground as if that were right below the root in the air too.</summary>
    [Theory]
    [InlineData(2, "Fly", Explicit = true)]
    [InlineData(22, "Fly", Explicit = true)]
    [InlineData(55, "Fly")]
    [InlineData(89, "Fly", Explicit = true)]
    [InlineData(278, "Hover")]
    public void No_flight_changes_its_pose_three_times_as_fast_as_usual(int seed, string name)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 0 }));
        Movement movement = Movement.Of(profile).Single(movement => movement.GaitName == name);
        foreach (float rate in new[] { 30f, 60f, 144f })
        {
            MotionReport report = new MotionTrial(movement, GroundRelief.Flat, rate).Run(profile);
            Assert.True(report.PoseJump <= 3f, $"{rate} Hz: {report.PoseJump}");
        }
    }

    [Theory]
    [InlineData(40)]
    [InlineData(400, Explicit = true)]
    public void Crawlers_change_their_pose_evenly_on_hills(int count)
    {
        foreach ((ulong seed, Creature creature) in Walkers.WithPlan(BodyPlan.Legless, count))
        {
            var profile = new MotionProfile(creature);
            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Relief == GroundRelief.Rough && trial.Hertz == 144f))
            {
                MotionReport report = trial.Run(profile);
                Assert.True(report.PoseJump <= 2f, $"{seed} {trial.Movement.Name}: {report.PoseJump}");
            }
        }
    }

    [Fact(Explicit = true)]
    public void Thirty_poses_a_second_are_enough_for_the_walks_of_dogs_and_cats()
    {
        int walks = 0;
        foreach ((ulong seed, Creature creature) in Walkers.WithPlan(BodyPlan.Digitigrade, 150))
        {
            var profile = new MotionProfile(creature);
            Movement walk = Movement.Of(profile).Single(movement => movement.GaitName == "Walk");
            CreatureAnimator animator = walk.Begin(profile, FlatGround.Level);
            var poses = new System.Numerics.Quaternion[3][];
            for (int i = 0; i < 240; i++)
            {
                animator.Update(1f / 60f, walk.Input, FlatGround.Level);
                (poses[0], poses[1], poses[2]) = (poses[1], poses[2], animator.LocalPose.Rotations.ToArray());
                for (int j = 0; i > 120 && j < creature.Skeleton.Count; j++)
                {
                    if (creature.Skeleton.Joints[j].Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle)
                    {
                        double missed = MovingPose.Between(Rotation.Slerp(poses[0][j], poses[2][j], 0.5), poses[1][j]);
                        Assert.True(missed < Scalar.Radians(6), $"{seed} {creature.Skeleton.Joints[j].Name}: half way between two keys it is {missed} rad off");
                    }
                }
            }

            walks++;
        }

        Assert.True(walks > 10, $"{walks}");
    }
}
