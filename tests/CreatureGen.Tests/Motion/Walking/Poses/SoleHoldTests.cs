using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Poses;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Poses;

public sealed class SoleHoldTests
{
    private delegate void Holding(LegRig leg, ref Foot foot, ref FootPose pose);

    [Fact]
    public void A_twisted_foot_that_rolls_from_edge_to_edge_slips_less_than_half_as_far_as_it_would()
    {
        foreach (ulong seed in new ulong[] { 3, 9, 42 })
        {
            float held = Slip(seed, static (LegRig leg, ref Foot foot, ref FootPose pose) => Hold(leg, ref foot, ref pose));
            float loose = Slip(seed, static (LegRig _, ref Foot _, ref FootPose _) => { });
            Assert.True(held < 0.5f * loose, $"{seed}: {held} metres of slip, and {loose} if it is not held");
        }
    }

    [Fact]
    public void Rolled_there_and_back_it_lies_where_it_lay()
    {
        (LegRig leg, Foot foot, FootPose flat) = Standing(42);
        FootPose first = Turned(leg, flat, TwistedRoll(leg, 0f));
        FootPose pose = first;
        for (int i = 0; i <= 40; i++)
        {
            pose = Turned(leg, flat, TwistedRoll(leg, 1f - Math.Abs(1f - (i / 20f))));
            Hold(leg, ref foot, ref pose);
        }

        Assert.True(Vec.Distance(first.Ball, pose.Ball) < 1e-5f * leg.Length, $"{Vec.Distance(first.Ball, pose.Ball)} metres from where it lay");
    }

    [Fact]
    public void In_the_air_it_comes_back_to_its_place()
    {
        (LegRig leg, Foot foot, FootPose flat) = Standing(42);
        for (int i = 0; i <= 40; i++)
        {
            FootPose pose = Turned(leg, flat, TwistedRoll(leg, i / 40f));
            Hold(leg, ref foot, ref pose);
        }

        foot.Leg.Turned.Stood = false;
        FootPose stands = flat;
        SoleHold.Carry(ref foot, ref stands);
        foot.Plan.Phase = FootPhase.Swing;
        foot.Plan.Swing = 0.9f;
        FootPose swings = flat;
        SoleHold.Carry(ref foot, ref swings);
        Assert.True(Vec.Distance(stands.Ball, flat.Ball) > 1e-3f * leg.Length);
        Assert.Equal(flat.Ball, swings.Ball);
    }

    /// <summary>A frog whose ankles twist its feet as it leaps, and six-legged hooves that their ankles tilt: 12 and 3.2 % of a leg before.</summary>
    [Theory]
    [InlineData(9920026, 144f)]
    [InlineData(9920011, 60f, Explicit = true)]
    public void Feet_that_their_ankles_turn_stay_where_they_stand(ulong seed, float hertz)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        MotionCourse course = MotionCourse.Of(profile).First(run => run.Ground == CourseGround.Flat && run.Rate.Hertz == hertz);
        float? slip = course.Run(profile).StanceSlip;
        Assert.True(slip < 0.02f, $"{slip} legs of slip");
    }

    [Theory]
    [InlineData(3)]
    [InlineData(9)]
    [InlineData(42)]
    public void A_turned_foot_that_has_rolled_down_within_one_update_stands_where_it_does_after_many(ulong seed)
    {
        const float strike = -0.2f;
        (LegRig leg, Foot often, FootPose flat) = Standing(seed);
        often.Leg.Turned.Away = new Vector3(0.01f, 0f, -0.02f) * leg.Length;
        Vector3 before = often.Leg.Turned.Away;
        Foot once = often;
        FootPose stands = flat;
        for (int i = 0; i <= 200; i++)
        {
            FootPose rolled = RolledTo(leg, often, flat, strike * (1f - (i / 200f)));
            stands = Turned(leg, rolled, Rotation.Multiply(Tilt(leg), rolled.Foot));
            Hold(leg, ref often, ref stands);
        }

        FootPose level = flat;
        SoleHold.Carry(ref once, ref level);
        FootPose pose = Turned(leg, level, Tilt(leg));
        once.Path.RolledDown = -strike;
        SoleHold.RollDown(leg, level, ref once, ref pose);
        SoleHold.Keep(leg, ref once, ref pose);
        float way = Vec.Distance(often.Leg.Turned.Away, before);
        Assert.True(way > 0.001f * leg.Length, $"{way / leg.Length} legs: nothing to miss");
        Assert.True(Vec.Distance(stands.Ball, pose.Ball) < 0.02f * way, $"{Vec.Distance(stands.Ball, pose.Ball)} of {way} metres apart");
    }

    private static void Hold(LegRig leg, ref Foot foot, ref FootPose pose)
    {
        SoleHold.Carry(ref foot, ref pose);
        SoleHold.Keep(leg, ref foot, ref pose);
        SoleHold.Remember(ref foot, pose);
    }

    /// <summary>How far what is lowest of a sole goes over the ground while the foot rolls, metres.</summary>
    private static float Slip(ulong seed, Holding hold)
    {
        (LegRig leg, Foot foot, FootPose flat) = Standing(seed);
        float slip = 0f;
        Vector3[]? before = null;
        for (int i = 0; i <= 200; i++)
        {
            FootPose pose = Turned(leg, flat, TwistedRoll(leg, i / 200f));
            hold(leg, ref foot, ref pose);
            Vector3[] after = Array.ConvertAll(leg.Sole, place => pose.Ball + Rotation.Rotate(pose.Toes, place));
            int lowest = Lowest(after);
            Vector3 moved = before == null ? default : after[lowest] - before[lowest];
            slip += Vec.Length(new Vector3(moved.X, 0f, moved.Z));
            before = after;
        }

        return slip;
    }

    /// <summary>Rolls over the fore edge to the side, twisted more and more.</summary>
    private static Quaternion TwistedRoll(LegRig leg, float way)
    {
        Quaternion twist = Rotation.FromAxisAngle(Vector3.UnitY, 0.4f * way);
        Quaternion roll = Rotation.FromAxisAngle(Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, 2.5f * way), leg.RollAxis), 0.25f);
        return Rotation.Multiply(roll, twist);
    }

    /// <summary>A foot that stands tilted about an axis between its length and its width.</summary>
    private static Quaternion Tilt(LegRig leg) => Rotation.FromAxisAngle(Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, 1.2f), leg.RollAxis), 0.3f);

    /// <summary>A foot pitched about its heel or its tip.</summary>
    private static FootPose RolledTo(LegRig leg, in Foot foot, FootPose flat, float pitch)
    {
        Quaternion turn = Rotation.FromAxisAngle(leg.RollAxis, pitch);
        Vector3 ball = flat.Ball + FootRoll.BallAt(leg, foot, pitch) - new Vector3(0f, leg.BallHeight, 0f);
        return new FootPose { Ball = ball, Target = ball, Foot = turn, Toes = turn };
    }

    /// <summary>The foot turned as its joints let it, as it is without being held.</summary>
    private static FootPose Turned(LegRig leg, FootPose flat, Quaternion turn)
    {
        LimitRelaxation.Turn(leg, Vector3.UnitY, turn, turn, 0f, 1f, ref flat);
        return flat;
    }

    private static int Lowest(Vector3[] points)
    {
        int lowest = 0;
        for (int i = 1; i < points.Length; i++)
        {
            lowest = points[i].Y < points[lowest].Y ? i : lowest;
        }

        return lowest;
    }

    private static (LegRig Leg, Foot Foot, FootPose Flat) Standing(ulong seed)
    {
        LegRig leg = new MotionProfile(Walkers.Any(seed)).Legs!.Legs[0];
        var foot = new Foot { Path = new FootPath { Base = leg.Home, Heading = Quaternion.Identity, Planned = Quaternion.Identity, Normal = Vector3.UnitY } };
        Vector3 ball = leg.Home + new Vector3(0f, leg.BallHeight, 0f);
        return (leg, foot, new FootPose { Ball = ball, Target = ball, Foot = Quaternion.Identity, Toes = Quaternion.Identity });
    }
}
