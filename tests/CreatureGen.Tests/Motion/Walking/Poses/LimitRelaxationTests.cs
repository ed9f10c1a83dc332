using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Poses;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Poses;

public sealed class LimitRelaxationTests
{
    [Fact]
    public void A_foot_that_is_let_lie_as_it_should_stays_as_it_is()
    {
        LegRig leg = Leg(42);
        FootPose pose = Flat(leg);
        FootPose before = pose;
        LimitRelaxation.Turn(leg, Vector3.UnitY, pose.Foot, pose.Toes, 0f, 1f, ref pose);
        Assert.True(Vec.Distance(before.Ball, pose.Ball) < 1e-6f);
        Assert.True(Vec.Distance(before.Target, pose.Target) < 1e-6f);
    }

    [Theory]
    [InlineData(0.2f)]
    [InlineData(-0.2f)]
    public void A_tilted_foot_stands_on_the_edge_that_is_lowest_and_that_edge_stays_where_it_was(float tilt)
    {
        foreach (ulong seed in new ulong[] { 3, 9, 42, 101, 125 })
        {
            LegRig leg = Leg(seed);
            FootPose flat = Flat(leg);
            FootPose pose = flat;
            Quaternion turn = Rotation.FromAxisAngle(leg.ToeDirection, tilt);
            LimitRelaxation.Turn(leg, Vector3.UnitY, turn, turn, 0f, 1f, ref pose);
            Vector3[] before = Array.ConvertAll(leg.Sole, place => flat.Ball + place);
            Vector3[] after = Array.ConvertAll(leg.Sole, place => pose.Ball + Rotation.Rotate(turn, place));
            int edge = 0;
            float width = 0f;
            for (int i = 0; i < after.Length; i++)
            {
                edge = after[i].Y < after[edge].Y ? i : edge;
                width = Math.Max(width, Vec.Distance(before[i], before[0]));
            }

            Assert.True(Math.Abs(after[edge].Y) < 1e-5f * leg.Length, $"{seed}: the lowest of the sole is at {after[edge].Y}");
            Vector3 moved = after[edge] - before[edge];
            Assert.True(Vec.Length(moved) < 0.02f * width, $"{seed}: the edge that it stands on goes {moved}, of a sole of {width}");
        }
    }

    [Fact]
    public void A_share_of_none_changes_nothing_and_half_of_it_goes_half_the_way()
    {
        LegRig leg = Leg(42);
        Quaternion turn = Rotation.FromAxisAngle(leg.ToeDirection, 0.2f);
        FootPose none = Flat(leg);
        FootPose half = none;
        FootPose whole = none;
        Vector3 ball = none.Ball;
        LimitRelaxation.Turn(leg, Vector3.UnitY, turn, turn, 0f, 0f, ref none);
        LimitRelaxation.Turn(leg, Vector3.UnitY, turn, turn, 0f, 0.5f, ref half);
        LimitRelaxation.Turn(leg, Vector3.UnitY, turn, turn, 0f, 1f, ref whole);
        Assert.True(Vec.Distance(none.Ball, ball) < 1e-7f);
        Assert.True(Vec.Distance(half.Ball, (ball + whole.Ball) * 0.5f) < 1e-6f);
    }

    [Theory]
    [InlineData(0.2f, 0f, Explicit = true)]
    [InlineData(-0.2f, 0f, Explicit = true)]
    [InlineData(0f, 0.2f, Explicit = true)]
    [InlineData(0f, -0.2f, Explicit = true)]
    public void Across_up_and_down_slopes_walkers_keep_to_the_limits_of_their_joints_and_stand_on_the_ground(float across, float along)
    {
        var ground = new FlatGround(Vector3.Zero, new Vector3(across, 1f, along));
        for (ulong seed = 300; seed < 340; seed++)
        {
            var profile = new MotionProfile(Walkers.Any(seed));
            if (profile.Gaits == null)
            {
                continue;
            }

            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), ground);
            var input = new MotionInput(Speed: profile.Gaits.Speeds[0].Comfortable);
            Walkers.Run(animator, 2f, 60f, input, ground);
            MotionReport report = Walkers.Measure(animator, 120, 60f, input, ground);
            string name = $"{seed} {profile.Subject.Plan}";
            Assert.True(report.LimitViolations == 0, $"{name}: {profile.Subject.Skeleton.Joints[Math.Max(report.WorstJoint, 0)].Name} beyond its limits by {report.LimitExcess}");
            Assert.True(report.MeanPenetration <= 0.004f, $"{name}: sunk {report.MeanPenetration}");
            Assert.True(report.Slip <= 0.003f, $"{name}: slip {report.Slip}");
        }
    }

    private static LegRig Leg(ulong seed) => new MotionProfile(Walkers.Any(seed)).Legs!.Legs[0];

    private static FootPose Flat(LegRig leg)
    {
        var ball = leg.Home + new Vector3(0f, leg.BallHeight, 0f);
        return new FootPose { Ball = ball, Foot = Quaternion.Identity, Toes = Quaternion.Identity, Target = leg.Traits.Linkage == LegLinkage.Pantograph ? ball : ball - leg.Metatarsus };
    }
}
