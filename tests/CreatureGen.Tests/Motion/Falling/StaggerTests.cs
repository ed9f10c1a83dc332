using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Steps of creatures that a blow pushes and does not knock down.</summary>
public sealed class StaggerTests
{
    private const float Rate = 120f;

    [Theory]
    [InlineData(0.3f, 0f)]
    [InlineData(-0.3f, 0f)]
    [InlineData(0f, 0.3f)]
    public void Feet_step_after_a_body_that_is_pushed_and_stand_still_between_their_steps(float aside, float ahead)
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(690, 8))
        {
            float length = profile.LegLength;
            string name = $"{profile.Subject.Seed}";
            var animator = new CreatureAnimator(profile);
            animator.Settings = animator.Settings with { Idle = 0f };
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            animator.Update(1f / Rate, default, FlatGround.Level);
            Vector3[] homes = Enumerable.Range(0, animator.FootCount).Select(foot => animator.Root.ToModel(animator.Foot(foot).Place)).ToArray();
            Vector3[] planted = Enumerable.Range(0, animator.FootCount).Select(foot => animator.Foot(foot).Place).ToArray();
            FootPhase[] before = planted.Select(_ => FootPhase.Stance).ToArray();
            int[] steps = new int[planted.Length];
            float unit = profile.Subject.Mass.Mass * (float)Math.Sqrt(9.81f * length);
            animator.Hit(profile.Subject.Skeleton.FirstOf(JointRole.Chest), new Vector3(aside, 0f, ahead) * unit);
            for (int i = 0; i < (int)(6f * Rate); i++)
            {
                animator.Update(1f / Rate, default, FlatGround.Level);
                Assert.Equal(BodyState.Supported, animator.State);
                for (int foot = 0; foot < planted.Length; foot++)
                {
                    FootReport report = animator.Foot(foot);
                    if (report.Phase == FootPhase.Stance)
                    {
                        bool landed = before[foot] == FootPhase.Swing;
                        steps[foot] += landed ? 1 : 0;
                        Assert.True(landed || Vec.Distance(report.Place, planted[foot]) < 1e-4f * length, $"{name}: foot {foot} slid");
                        planted[foot] = report.Place;
                    }

                    before[foot] = report.Phase;
                }
            }

            // Nobody is left standing crooked, and whoever was moved by more than feet may be off their homes has stepped.
            var way = new Vector3(animator.Root.Position.X, 0f, animator.Root.Position.Z);
            Assert.True(Vec.Length(way) > 0.03f * length, $"{name}: pushed by {Vec.Length(way)} m alone");
            Assert.True(Vec.Dot(way, new Vector3(aside, 0f, ahead)) > 0f, $"{name}: pushed to {way}");
            Assert.All(steps, count => Assert.InRange(count, 1, 8));
            for (int foot = 0; foot < planted.Length; foot++)
            {
                float off = Vec.Distance(animator.Root.ToModel(animator.Foot(foot).Place), homes[foot]);
                Assert.True(animator.Foot(foot).Phase == FootPhase.Stance && off < 0.03f * length, $"{name}: foot {foot} ends {off / length} leg lengths from home");
            }
        }
    }

    [Fact]
    public void Lids_of_who_is_struck_twice_do_not_open_at_once_with_the_second_blow()
    {
        const float Hertz = 480f;
        const float Fastest = 60f;
        foreach (MotionProfile profile in FreeFallTests.Lot(690, 8))
        {
            Skeleton skeleton = profile.Subject.Skeleton;
            int lid = skeleton.FirstOf(JointRole.Lid);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            Quaternion before = lid < 0 ? Quaternion.Identity : animator.LocalPose.Rotations[lid];
            for (int i = 0; lid >= 0 && i < (int)Hertz; i++)
            {
                if (i % 120 == 0)
                {
                    animator.Hit(skeleton.FirstOf(JointRole.Body), new Vector3(1e-4f, 0f, 0f));
                }

                animator.Update(1f / Hertz, default, FlatGround.Level);
                Quaternion turn = Rotation.Multiply(Rotation.Inverse(before), animator.LocalPose.Rotations[lid]);
                before = animator.LocalPose.Rotations[lid];
                float speed = 2f * new Vector3(turn.X, turn.Y, turn.Z).Length() * Hertz;
                Assert.True(speed < Fastest, $"{profile.Subject.Seed}: {skeleton.Joints[lid].Name} turns by {speed} rad/s");
            }
        }
    }
}
