using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Wings of fliers that stand or walk.</summary>
public sealed class FoldedWingTests
{
    [Fact(Explicit = true)]
    public void Folded_wings_end_near_the_root_of_the_tail()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9000, Thoroughness.Of(120)).Where(flier => flier.IsStitched))
        {
            flier.Stand(FlatGround.Level);
            Vector3 back = flier.PlaceOf(JointRole.Pelvis) - flier.PlaceOf(JointRole.Chest);
            back = Vector3.Normalize(back with { X = 0f });
            Vector3 root = flier.TailBase();
            double beyond = flier.Wings().Max(point => Vector3.Dot(point - root, back)) / flier.Length;
            Assert.True(beyond < 0.18, $"{flier.Name}: {beyond} body lengths beyond the root of the tail");
            double across = flier.Wings().Max(point => Math.Abs(point.X)) / flier.Length;
            Assert.True(across < 0.25, $"{flier.Name}: {across} body lengths to the side");
        }
    }

    [Fact]
    public void Folded_wings_keep_off_legs_and_ground_within_the_limits_of_their_joints()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9200, Thoroughness.Of(60)))
        {
            flier.Stand(FlatGround.Level);
            Assert.True(flier.InLegs() < 0.03, $"{flier.Name}: {flier.InLegs()} leg lengths in its legs");
            double height = flier.Wings().Min(point => point.Y) / flier.Profile.LegLength;
            Assert.True(height > 0.15, $"{flier.Name}: wings {height} leg lengths above the ground");
            Skeleton skeleton = flier.Creature.Skeleton;
            for (int j = 0; j < skeleton.Count; j++)
            {
                Joint joint = skeleton.Joints[j];
                Quaternion turn = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), flier.Animator.LocalPose.Rotations[j]));
                Assert.True(joint.Role != JointRole.Wing || SwingTwistLimit.Excess(turn, joint.Limit) < 1e-3f, $"{flier.Name} {joint.Name}");
            }
        }
    }

    [Fact(Explicit = true)]
    public void Folded_wings_hardly_touch_walking_legs_nor_hills()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9300, Thoroughness.Of(40)))
        {
            float length = flier.Profile.LegLength;
            HeightFieldGround hills = new HillField(new Seed(flier.Creature.Blueprint.Seed), length).Around((6f * length) + 4f, -4f, (20f * length) + 8f);
            float speed = flier.Profile.Gaits!.Speeds[0].Comfortable;
            flier.Stand(hills);
            for (int i = 0; i < 12; i++)
            {
                flier.Go(0.15f, speed, hills);
                Assert.True(flier.InLegs() < 0.13, $"{flier.Name}: {flier.InLegs()} leg lengths in its legs");
                foreach (Vector3 point in flier.Wings())
                {
                    Vector3 place = flier.Animator.Root.ToWorld(point);
                    Assert.True(hills.Cast(place + new Vector3(0f, 10f, 0f), -Vector3.UnitY, 40f, out GroundHit hit));
                    Assert.True(place.Y > hit.Point.Y, $"{flier.Name}: a wing is {(hit.Point.Y - place.Y) / length} leg lengths in the ground");
                }
            }
        }
    }

    [Fact]
    public void Bodies_hardly_show_through_folded_wings()
    {
        StandingFlier[] fliers = StandingFlier.Of(5000, Thoroughness.Of(60)).Where(flier => flier.IsStitched).ToArray();
        double sum = 0;
        foreach (StandingFlier flier in fliers)
        {
            flier.Stand(FlatGround.Level);
            double fraction = SideView.BodyThroughWing(flier);
            Assert.True(fraction < 0.04, $"{flier.Name}: {fraction} of the wing has the body in front of it");
            sum += fraction;
        }

        Assert.True(sum / fliers.Length < 0.008, $"{sum / fliers.Length} in the mean");
    }

    [Fact(Explicit = true)]
    public void Bodies_hardly_show_through_folded_wings_at_a_gallop()
    {
        foreach (StandingFlier flier in StandingFlier.Of(5000, Thoroughness.Of(60)).Where(flier => flier.IsStitched && flier.Profile.Gaits!.Speeds[^1].Gait.Name.Contains("Gallop", StringComparison.Ordinal)))
        {
            flier.Stand(FlatGround.Level);
            flier.Go(3f, flier.Profile.Gaits!.Speeds[^1].Comfortable, FlatGround.Level);
            for (int i = 0; i < 8; i++)
            {
                flier.Go(0.05f, flier.Profile.Gaits!.Speeds[^1].Comfortable, FlatGround.Level);
                double fraction = SideView.BodyThroughWing(flier);
                Assert.True(fraction < 0.10, $"{flier.Name}: {fraction} of the wing has the body in front of it");
                Assert.True(flier.InLegs() < 0.10, $"{flier.Name}: {flier.InLegs()} leg lengths in its legs");
                double height = flier.Wings().Min(point => point.Y) / flier.Profile.LegLength;
                Assert.True(height > 0.15, $"{flier.Name}: wings {height} leg lengths above the ground");
            }
        }
    }

    [Fact]
    public void Folded_wings_are_mirror_images()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9400, 15))
        {
            flier.Stand(FlatGround.Level);
            Skeleton skeleton = flier.Creature.Skeleton;
            for (int j = 0; j < skeleton.Count; j++)
            {
                if (skeleton.Joints[j].Role == JointRole.Wing)
                {
                    Vector3 own = flier.Animator.ModelPose.Positions[j];
                    Vector3 other = flier.Animator.ModelPose.Positions[skeleton.Mirrors[j]];
                    Assert.True(Vector3.Distance(own, Vec.Mirror(other)) < 0.01f * flier.Profile.LegLength, $"{flier.Name} {skeleton.Joints[j].Name}");
                }
            }
        }
    }

    [Fact]
    public void Folded_wings_swing_with_the_steps_of_the_same_update()
    {
        // After a long update a short one showed all of that at once: 74 rad/s.
        foreach (StandingFlier flier in StandingFlier.Of(9500, 8))
        {
            flier.Stand(FlatGround.Level);
            flier.Go(2f, flier.Profile.Gaits!.Speeds[^1].Comfortable, FlatGround.Level);
            flier.Animator.Update(0.1f, new MotionInput(0f), FlatGround.Level);
            Quaternion[] before = flier.Animator.LocalPose.Rotations.ToArray();
            flier.Animator.Update(0.001f, new MotionInput(0f), FlatGround.Level);
            for (int j = 0; j < before.Length; j++)
            {
                float turned = (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), flier.Animator.LocalPose.Rotations[j]));
                Assert.True(flier.Creature.Skeleton.Joints[j].Role != JointRole.Wing || turned < 0.03f, $"{flier.Name} {flier.Creature.Skeleton.Joints[j].Name}: {turned} rad in a millisecond");
            }
        }
    }
}
