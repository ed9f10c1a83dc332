using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Bodies;

/// <summary>How fliers hold themselves where they stand.</summary>
public sealed class StandingPostureTests
{
    [Fact]
    public void Birds_stand_raised_perching_ones_more_than_ducks()
    {
        int perching = 0;
        int ducks = 0;
        foreach (StandingFlier flier in StandingFlier.Of(9500, Thoroughness.Of(120)).Where(flier => flier.Creature.Blueprint.Legs.Count == 1))
        {
            flier.Stand(FlatGround.Level);
            double degrees = Degrees(flier);
            switch (flier.Creature.Blueprint.Body.Blend.First)
            {
                case "raptor" or "parrot" or "toucan" or "heron":
                    Assert.InRange(degrees, 19, 48);
                    perching++;
                    break;
                case "owl":
                    Assert.InRange(degrees, 40, 60);
                    perching++;
                    break;
                case "duck":
                    Assert.InRange(degrees, 12, 26);
                    ducks++;
                    break;
            }
        }

        Assert.True(perching > Thoroughness.Of(20), $"{perching}");
        Assert.True(ducks > Thoroughness.Of(2), $"{ducks}");
    }

    [Fact]
    public void Heads_of_raised_fliers_are_level_and_tails_clear_of_the_ground()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9700, Thoroughness.Of(60)).Where(flier => flier.Profile.Legs!.Posture.Raised > 0f))
        {
            flier.Stand(FlatGround.Level);
            Skeleton skeleton = flier.Creature.Skeleton;
            int head = Enumerable.Range(0, skeleton.Count).First(j => skeleton.Joints[j].Role == JointRole.Head);
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(flier.Animator.ModelPose.Rotations[head], Rotation.Inverse(skeleton.ModelRotations[head])), Vector3.UnitZ);
            Assert.True(Math.Abs(ahead.Y) < 0.12, $"{flier.Name}: the head looks up by {ahead.Y}");
            foreach (CapsuleCollider bone in flier.Creature.Bones.Where(bone => skeleton.Joints[bone.Joint].Role == JointRole.Tail))
            {
                double rest = skeleton.ModelPositions[bone.Joint].Y - (0.3 * bone.Radius);
                double height = flier.Animator.ModelPose.Positions[bone.Joint].Y - (0.3 * bone.Radius);
                Assert.True(height > Math.Min(rest, 0.1 * flier.Profile.LegLength) - (0.05 * flier.Profile.LegLength), $"{flier.Name}: its tail is {height} m above the ground, at rest {rest}");
            }
        }
    }

    /// <summary>The posture's own account of the mass is of capsules at rest: here they are where the joints take them.</summary>
    [Fact]
    public void Raised_fliers_keep_their_centre_of_mass_over_their_feet()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9800, Thoroughness.Of(60)).Where(flier => flier.Profile.Legs!.Posture.Raised > 0f))
        {
            flier.Stand(FlatGround.Level);
            Skeleton skeleton = flier.Creature.Skeleton;
            double built = Centre(flier, new Pose(skeleton.ModelRotations.ToArray(), skeleton.ModelPositions.ToArray()));
            double stands = Centre(flier, flier.Animator.ModelPose);
            Assert.True(Math.Abs(stands - built) < 0.06 * flier.Profile.LegLength, $"{flier.Name}: {(stands - built) / flier.Profile.LegLength} leg lengths off");
        }
    }

    [Fact]
    public void Fliers_on_four_legs_insects_and_walkers_stand_as_they_are_built()
    {
        foreach (StandingFlier flier in StandingFlier.Of(9900, Thoroughness.Of(60)).Where(flier => flier.Profile.Legs!.Legs.Length > 2))
        {
            Assert.Equal(0f, flier.Profile.Legs!.Posture.Raised);
        }

        foreach (BodyPlan plan in new[] { BodyPlan.Theropod, BodyPlan.Upright, BodyPlan.Digitigrade })
        {
            Assert.Equal(0f, StandingPosture.Of(new MotionSubject(Walkers.Of(plan, 4))).Raised);
        }
    }

    [Fact]
    public void A_raised_trunk_comes_down_to_walk_and_farther_to_run()
    {
        StandingFlier flier = StandingFlier.Of(9700, 60).First(flier => flier.Profile.Legs!.Posture.Raised > 0.4f && flier.Profile.Gaits!.Speeds.Count > 1);
        flier.Stand(FlatGround.Level);
        double stands = Degrees(flier);
        flier.Go(3f, flier.Profile.Gaits!.Speeds[0].Comfortable, FlatGround.Level);
        double walks = Degrees(flier);
        flier.Go(3f, flier.Profile.Gaits.Speeds[1].Fastest, FlatGround.Level);
        double runs = Degrees(flier);
        Assert.True(stands > walks + 5 && walks > runs + 3, $"{flier.Name}: stands {stands}, walks {walks}, runs {runs} degrees");
        Assert.Equal(1f, StandingPosture.Fraction(0f, 0f, 0f));
        Assert.InRange(StandingPosture.Fraction(1f, 4f, 0f), 0.1f, 0.3f);
        Assert.InRange(StandingPosture.Fraction(0f, 0f, 0.3f), 0.2f, 0.4f);
    }

    private static double Degrees(StandingFlier flier)
    {
        Vector3 back = flier.PlaceOf(JointRole.Chest) - flier.PlaceOf(JointRole.Pelvis);
        return Scalar.Degrees(Math.Atan2(back.Y, back.Z));
    }

    /// <summary>How far ahead the middle of the capsules of trunk, neck, head and tail is.</summary>
    private static double Centre(StandingFlier flier, Pose model)
    {
        double moment = 0;
        double mass = 0;
        foreach (CapsuleCollider bone in flier.Creature.Bones)
        {
            if (flier.Creature.Skeleton.Joints[bone.Joint].Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Neck or JointRole.Head or JointRole.Tail)
            {
                double volume = bone.Radius * bone.Radius * (Vector3.Distance(bone.Start, bone.End) + (4.0 / 3 * bone.Radius));
                moment += volume * (model.Positions[bone.Joint] + Rotation.Rotate(model.Rotations[bone.Joint], (bone.Start + bone.End) * 0.5f)).Z;
                mass += volume;
            }
        }

        return moment / mass;
    }
}
