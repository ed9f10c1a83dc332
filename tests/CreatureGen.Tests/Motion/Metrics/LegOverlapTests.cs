using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Metrics;

public sealed class LegOverlapTests
{
    [Fact]
    public void Legs_at_rest_do_not_overlap_and_those_that_are_put_into_one_another_do()
    {
        var profile = new MotionProfile(Walkers.Any(22));
        LeggedBody body = profile.Legs!;
        var overlap = new LegOverlap(body);
        var animator = new CreatureAnimator(profile);
        Pose model = animator.ModelPose;
        body.Skeleton.ModelPositions.CopyTo(model.Positions);
        body.Skeleton.ModelRotations.CopyTo(model.Rotations);
        overlap.Measure(model);
        Assert.Equal(0f, overlap.Deepest);
        Assert.Equal(0f, overlap.DeepestInTrunk);
        Assert.Equal((-1, -1), overlap.Worst);

        // The left foremost leg is moved over into the right one.
        LegRig left = body.Legs.First(leg => leg.Side == CreatureGen.Anatomy.Side.Left);
        int other = Array.FindIndex(body.Legs, leg => leg.Side != left.Side && leg.Row == left.Row);
        Vector3 way = body.Legs[other].Home - left.Home;
        foreach (int joint in new[] { left.Hip, left.Knee, left.Ankle, left.Ball })
        {
            model.Positions[joint] += way;
        }

        overlap.Measure(model);
        float radius = body.Subject.Bones.Single(bone => bone.Joint == left.Ankle).Radius;
        Assert.True(overlap.Deepest > radius, $"{overlap.Deepest} m");
        Assert.Contains(other, new[] { overlap.Worst.First, overlap.Worst.Second });
    }

    [Fact]
    public void A_foot_that_is_put_into_the_belly_is_as_deep_in_it_as_the_capsules_say()
    {
        LeggedBody body = new MotionProfile(Walkers.Any(22)).Legs!;
        var overlap = new LegOverlap(body);
        Pose model = new CreatureAnimator(new MotionProfile(body.Subject)).ModelPose;
        body.Skeleton.ModelPositions.CopyTo(model.Positions);
        body.Skeleton.ModelRotations.CopyTo(model.Rotations);
        int thigh = body.Legs[0].Hip;
        CapsuleCollider belly = body.Subject.Bones.First(bone => bone.Joint == body.Trunk[0]);
        CapsuleCollider foot = body.Subject.Bones.First(bone => bone.Joint == body.Legs[0].Ankle);

        // Thighs are of one skin with the trunk.
        Vector3 hip = model.Positions[thigh];
        model.Positions[thigh] = model.Positions[belly.Joint];
        overlap.Measure(model);
        Assert.Equal(0f, overlap.DeepestInTrunk);
        model.Positions[thigh] = hip;

        model.Positions[foot.Joint] = model.Positions[belly.Joint] + Rotation.Rotate(model.Rotations[belly.Joint], belly.Start) - Rotation.Rotate(model.Rotations[foot.Joint], foot.Start);
        overlap.Measure(model);
        Assert.True(overlap.DeepestInTrunk >= belly.Radius + foot.Radius - 1e-4f, $"{overlap.DeepestInTrunk} m");
    }

    /// <summary>Bears and their like, whose thighs touch at rest.</summary>
    [Theory]
    [InlineData(55)]
    [InlineData(2108)]
    [InlineData(2297)]
    [InlineData(7011)]
    public void Thick_thighs_go_past_each_other_in_a_gallop(int seed)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        LeggedBody body = profile.Legs!;
        CapsuleCollider[] thighs = body.Subject.Bones.Where(bone => body.Legs.Any(leg => leg.Row == 0 && leg.Hip == bone.Joint)).ToArray();
        Movement gallop = Movement.Of(profile).Single(movement => movement.GaitName == "TransverseGallop");
        CreatureAnimator animator = gallop.Begin(profile, FlatGround.Level);
        float rest = Depth(body.Skeleton.ModelPositions, body.Skeleton.ModelRotations);
        float deepest = 0f;
        for (int i = 0; i < 300; i++)
        {
            animator.Update(1f / 60f, gallop.Input, FlatGround.Level);
            deepest = Math.Max(deepest, Depth(animator.ModelPose.Positions, animator.ModelPose.Rotations) - Math.Max(rest, 0f));
        }

        Assert.Equal(2, thighs.Length);
        Assert.True(deepest < 0.02f * body.LegLength, $"{deepest / body.LegLength} leg lengths");

        float Depth(ReadOnlySpan<Vector3> positions, ReadOnlySpan<Quaternion> rotations)
        {
            CapsuleCollider a = thighs[0];
            CapsuleCollider b = thighs[1];
            return a.Radius + b.Radius - MathF.Sqrt(SegmentDistance.Squared(Place(a, a.Start, positions, rotations), Place(a, a.End, positions, rotations), Place(b, b.Start, positions, rotations), Place(b, b.End, positions, rotations)));
        }

        static Vector3 Place(CapsuleCollider bone, Vector3 point, ReadOnlySpan<Vector3> positions, ReadOnlySpan<Quaternion> rotations) =>
            positions[bone.Joint] + Rotation.Rotate(rotations[bone.Joint], point);
    }

    [Theory]
    [InlineData(109, "Waddle", 0.02f)]
    [InlineData(113, "Waddle", 0.02f, Explicit = true)]
    [InlineData(2023, "Waddle", 0.02f, Explicit = true)]
    [InlineData(7298, "Waddle", 0.02f, Explicit = true)]
    [InlineData(109, "WaddleRun", 0.02f)]
    [InlineData(113, "WaddleRun", 0.06f, Explicit = true)]
    [InlineData(2023, "WaddleRun", 0.05f, Explicit = true)]
    [InlineData(7298, "WaddleRun", 0.08f)]
    public void Penguins_lift_their_feet_off_the_ground_and_not_into_their_rumps(int seed, string gait, float max)
    {
        var profile = new MotionProfile(Walkers.Any((ulong)seed));
        Movement movement = Movement.Of(profile).Single(movement => movement.GaitName == gait);
        MotionReport report = new MotionTrial(movement, GroundRelief.Flat, 60f).Run(profile);
        Assert.InRange(report.BellyOverlap!.Value, 0f, max);
        Assert.True(report.Clearance > 0.05f, $"{report.Clearance}");
    }

    [Fact(Explicit = true)]
    public void Hind_feet_of_four_footed_walkers_do_not_run_into_their_fore_feet()
    {
        var found = new List<float>();
        for (ulong seed = 9000; seed < 9000 + (ulong)Thoroughness.Of(50); seed++)
        {
            var profile = new MotionProfile(Walkers.Any(seed));
            if (profile.Legs?.Rows != 2)
            {
                continue;
            }

            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Hertz == 60f && trial.Relief == GroundRelief.Flat))
            {
                float overlap = trial.Run(profile).LegOverlap!.Value;
                Assert.True(overlap < 0.1f, $"{seed} {trial.Movement.GaitName}: legs {overlap} leg lengths into one another");
                found.Add(overlap);
            }
        }

        Assert.True(found.Count > Thoroughness.Of(60));
        Assert.True(found.Count(overlap => overlap > 0.02f) < 0.15f * found.Count, $"{found.Count(overlap => overlap > 0.02f)} of {found.Count}");
    }

    [Theory]
    [InlineData(BodyPlan.ManyLegged, 0.1f, Explicit = true)]
    [InlineData(BodyPlan.Hexapod, 0.02f)]
    [InlineData(BodyPlan.Theropod, 0.03f, Explicit = true)]
    public void Neighbouring_legs_and_the_feet_of_bipeds_keep_apart(BodyPlan plan, float max)
    {
        int found = 0;
        for (ulong seed = 9000; seed < 9016; seed++)
        {
            var profile = new MotionProfile(Walkers.Of(plan, seed));
            foreach (MotionTrial trial in MotionTrial.Of(profile).Where(trial => trial.Movement.Gait != null && trial.Hertz == 60f && trial.Relief == GroundRelief.Flat))
            {
                float overlap = trial.Run(profile).LegOverlap!.Value;
                Assert.True(overlap < max, $"{seed} {trial.Movement.GaitName}: legs {overlap} leg lengths into one another");
                found++;
            }
        }

        Assert.True(found >= 16);
    }
}
