using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.RootMotion;

public sealed class RootMotionTests
{
    [Fact]
    public void Damping_halves_in_its_half_life_and_two_half_steps_make_a_whole()
    {
        float rate = Damping.RateOfHalfLife(0.5f);
        Assert.Equal(5f, Damping.Approach(10f, 0f, rate, 0.5f), 1e-5f);
        Assert.Equal(Damping.Approach(10f, 2f, 7f, 0.2f), Damping.Approach(Damping.Approach(10f, 2f, 7f, 0.1f), 2f, 7f, 0.1f), 1e-5f);
        Assert.Equal(0f, Damping.Approach(1f, 0f, 1e4f, 10f));
        Assert.Equal(3f, Damping.Approach(3f, 9f, 5f, 0f));
        Assert.Equal(0.25f, Damping.Integral(0f, 0.25f));
        Assert.Equal((1 - Math.Exp(-2)) / 4, Damping.Integral(4f, 0.5f), 1e-6);
        Assert.True(MovingPose.Between(Rotation.FromAxisAngle(Vector3.UnitX, 0.5), Damping.Approach(Quaternion.Identity, Rotation.FromAxisAngle(Vector3.UnitX, 1), Damping.RateOfHalfLife(1f), 1f)) < 1e-5);
    }

    [Fact]
    public void Following_a_moving_goal_is_exact_at_any_step_and_trails_by_speed_over_rate()
    {
        float fine = 0f;
        float coarse = 0f;
        for (int i = 0; i < 1000; i++)
        {
            fine = Damping.Follow(fine, i * 0.003f, (i + 1) * 0.003f, 8f, 0.001f);
        }

        for (int i = 0; i < 10; i++)
        {
            coarse = Damping.Follow(coarse, i * 0.3f, (i + 1) * 0.3f, 8f, 0.1f);
        }

        Assert.Equal(fine, coarse, 1e-4f);
        Assert.Equal(3f - (3f / 8f), coarse, 1e-3f);
        Assert.Equal(new Vector3(coarse), Damping.Follow(new Vector3(coarse), Vector3.One, Vector3.One, 8f, 0f));
    }

    [Theory]
    [InlineData(0.2f)]
    [InlineData(1f)]
    [InlineData(2.5f)]
    public void A_damped_spring_agrees_with_a_thousand_small_steps_and_never_blows_up(float ratio)
    {
        var step = new DampedSpring(9f, ratio, 0.1f);
        double x = 0.7;
        double v = -2;
        for (int i = 0; i < 100000; i++)
        {
            v += ((-81 * x) - (2 * ratio * 9 * v)) * 1e-6;
            x += v * 1e-6;
        }

        Assert.Equal(x, (step.PlaceOfPlace * 0.7f) + (step.PlaceOfVelocity * -2f), 1e-4);
        Assert.Equal(v, (step.VelocityOfPlace * 0.7f) + (step.VelocityOfVelocity * -2f), 1e-3);
        var stiff = new DampedSpring(1e5f, ratio, 0.25f);
        Assert.True(Math.Abs(stiff.PlaceOfPlace) <= 1f && Math.Abs(stiff.VelocityOfVelocity) <= 1f);
        var none = new DampedSpring(0f, ratio, 0.25f);
        Assert.Equal((1f, 0.25f, 0f, 1f), (none.PlaceOfPlace, none.PlaceOfVelocity, none.VelocityOfPlace, none.VelocityOfVelocity));
    }

    [Fact]
    public void A_critical_spring_arrives_without_swinging_through_at_any_step()
    {
        float x = 0f, v = 0f, y = 0f, w = 0f;
        for (int i = 0; i < 100; i++)
        {
            CriticallyDampedSpring.Advance(ref x, ref v, 1f, 8f, 0.01f);
            Assert.InRange(x, 0f, 1f);
        }

        CriticallyDampedSpring.Advance(ref y, ref w, 1f, 8f, 0.4f);
        CriticallyDampedSpring.Advance(ref y, ref w, 1f, 8f, 0.6f);
        Assert.Equal(y, x, 1e-5f);
        Assert.Equal(1 - ((1 + 8) * Math.Exp(-8)), x, 1e-5);
    }

    [Fact]
    public void The_path_does_not_depend_on_the_frame_rate()
    {
        var goal = new BodyVelocity(new Vector3(0.3f, 0.1f, 3f), 2.5f);
        (RootPlace expected, BodyVelocity end) = Drive(goal, 1f / 1000f, 2000);
        foreach (int frames in new[] { 8, 60, 120, 288 })
        {
            (RootPlace place, BodyVelocity velocity) = Drive(goal, 2f / frames, frames);
            Assert.True(Vec.Distance(expected.Position, place.Position) < 2e-4f, $"{frames}: {Vec.Distance(expected.Position, place.Position)}");
            Assert.True(MovingPose.Between(expected.Rotation, place.Rotation) < 2e-4);
            Assert.True(Vec.Distance(end.Linear, velocity.Linear) < 1e-5f);
        }
    }

    [Fact]
    public void Straight_ahead_from_a_standstill_covers_the_textbook_distance()
    {
        BodyVelocity velocity = default;
        RootDelta delta = VelocityDamping.Advance(ref velocity, new BodyVelocity(new Vector3(0f, 0f, 2f), 0f), 5f, 5f, 1f);
        Assert.Equal(2 - (2 * (1 - Math.Exp(-5)) / 5), delta.Shift.Z, 1e-5);
        Assert.Equal(2 * (1 - Math.Exp(-5)), velocity.Linear.Z, 1e-5);
        Assert.Equal(0f, delta.Turn);
    }

    [Fact]
    public void At_a_steady_turn_the_path_is_a_circle()
    {
        var steady = new BodyVelocity(new Vector3(0f, 0f, 3f), 1.5f);
        BodyVelocity velocity = steady;
        var place = new RootPlace(Vector3.Zero, Quaternion.Identity);
        for (int i = 0; i < 100; i++)
        {
            place = VelocityDamping.Advance(ref velocity, steady, 5f, 5f, (float)(PortableMath.Tau / 150)).From(place);
            Assert.Equal(2f, Vec.Distance(place.Position, new Vector3(2f, 0f, 0f)), 1e-4f);
        }

        Assert.True(Vec.Length(place.Position) < 1e-3f, $"{place.Position}");
    }

    [Fact]
    public void The_mirror_image_of_a_path_is_the_path_of_the_mirrored_command()
    {
        (RootPlace left, _) = Drive(new BodyVelocity(new Vector3(0.3f, 0f, 3f), 2.5f), 1f / 60f, 60);
        (RootPlace right, _) = Drive(new BodyVelocity(new Vector3(-0.3f, 0f, 3f), -2.5f), 1f / 60f, 60);
        Assert.True(Vec.Distance(Vec.Mirror(left.Position), right.Position) < 1e-5f);
        Assert.True(MovingPose.Between(Rotation.Mirror(left.Rotation), right.Rotation) < 1e-5);
    }

    [Fact]
    public void A_seeker_turns_first_comes_into_its_band_and_stands_still_there()
    {
        RandomStream random = new Seed(2).Stream();
        for (int i = 0; i < 100; i++)
        {
            Vector3 target = MovingPose.Direction(random) * (float)random.Uniform(0.1, 30);
            SeekState state = default;
            BodyVelocity velocity = default;
            var place = new RootPlace(new Vector3(1f, 0f, 2f), Rotation.FromAxisAngle(Vector3.UnitY, random.Uniform(-3, 3)));
            int acts = 0;
            SeekAct last = SeekAct.Hold;
            for (int k = 0; k < 60 * 40; k++)
            {
                Vector3 seen = place.ToModel(target);
                BodyVelocity goal = Seek.Decide(ref state, SeekSettings.Default, seen);
                if (seen.Z < 0f)
                {
                    Assert.Equal(0f, goal.Linear.Z);
                }

                acts += state.Doing != last ? 1 : 0;
                last = state.Doing;
                place = VelocityDamping.Advance(ref velocity, goal, 5f, 5f, 1f / 60f).From(place);
            }

            Vector3 left = place.ToModel(target);
            float distance = Vec.Length(new Vector3(left.X, 0f, left.Z));
            Assert.InRange(distance, 4.5f, 6f);
            Assert.True(Math.Abs(left.X) < 0.36f * distance && left.Z > 0f, $"{i}: {left}");
            Assert.True(Vec.Length(velocity.Linear) < 0.05f && Math.Abs(velocity.YawRate) < 0.05f);
            Assert.True(acts <= 3, $"{i}: {acts}");
        }
    }

    [Fact]
    public void A_target_at_its_feet_above_it_or_not_a_number_is_handled()
    {
        SeekState state = default;
        BodyVelocity away = Seek.Decide(ref state, SeekSettings.Default, Vector3.Zero);
        Assert.True(away.Linear.Z < 0f && away.YawRate == 0f);
        Seek.Decide(ref state, SeekSettings.Default, new Vector3(0f, 100f, 0f));
        Assert.Equal(SeekAct.Retreat, state.Doing);
        Assert.Throws<ArgumentException>(() => Seek.Decide(ref state, SeekSettings.Default, new Vector3(float.NaN)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SeekSettings(2f, near: 5f, far: 4f));
    }

    [Fact]
    public void A_pushed_creature_knows_its_velocity_whatever_the_steps_and_a_teleport_does_not_disturb_it()
    {
        var steady = new BodyVelocity(new Vector3(0.5f, 0f, 3f), 1.2f);
        foreach (float step in new[] { 1f / 30f, 1f / 60f, 1f / 144f })
        {
            foreach (float scale in new[] { 0.05f, 1f, 20f })
            {
                PushedRoot pushed = default;
                BodyVelocity velocity = steady;
                var place = new RootPlace(new Vector3(10f, 0f, 0f), Rotation.FromAxisAngle(Vector3.UnitY, 2), scale);
                for (float t = 0; t < 1f; t += step)
                {
                    pushed.Observe(place, 15f, step, 50f);
                    place = VelocityDamping.Advance(ref velocity, steady, 5f, 5f, step).From(place);
                }

                Assert.True(Vec.Distance(steady.Linear, pushed.Velocity.Linear) < 0.01f, $"{pushed.Velocity}");
                Assert.Equal(1.2f, pushed.Velocity.YawRate, 0.01f);
                BodyVelocity before = pushed.Velocity;
                Assert.Equal(before, pushed.Observe(new RootPlace(place.Position + (Vector3.One * 1000f), place.Rotation, scale), 15f, step));
                Assert.Equal(before, pushed.Observe(place, 15f, 0f));
                pushed.Rebase(new Vector3(500f, 0f, 0f));
                pushed.Observe(new RootPlace(place.Position + new Vector3(500f, 0f, 0f), place.Rotation, scale), 15f, step);
                Assert.True(Vec.Length(pushed.Velocity.Linear) < Vec.Length(before.Linear));
            }
        }
    }

    [Fact]
    public void Places_lead_to_the_world_and_back()
    {
        RandomStream random = new Seed(4).Stream();
        for (int i = 0; i < 200; i++)
        {
            var place = new RootPlace(MovingPose.Direction(random) * 10f, MovingPose.AnyRotation(random), (float)random.Uniform(0.05, 20));
            Vector3 point = MovingPose.Direction(random);
            Assert.True(Vec.Distance(point, place.ToModel(place.ToWorld(point))) < 1e-4f);
        }

        Assert.Throws<ArgumentOutOfRangeException>(() => new RootPlace(Vector3.Zero, Quaternion.Identity, 0f));
    }

    [Fact]
    public void Driving_allocates_nothing()
    {
        SeekState state = default;
        BodyVelocity velocity = default;
        PushedRoot pushed = default;
        Assert.Equal(0, MovingPose.Allocated(() =>
        {
            BodyVelocity goal = Seek.Decide(ref state, SeekSettings.Default, new Vector3(3f, 0f, 9f));
            RootPlace place = VelocityDamping.Advance(ref velocity, goal, 5f, 5f, 0.02f).From(RootPlace.Identity);
            pushed.Observe(place, 15f, 0.02f);
        }));
    }

    private static (RootPlace Place, BodyVelocity Velocity) Drive(BodyVelocity goal, float step, int steps)
    {
        BodyVelocity velocity = default;
        var place = new RootPlace(Vector3.Zero, Quaternion.Identity);
        for (int i = 0; i < steps; i++)
        {
            place = VelocityDamping.Advance(ref velocity, goal, 5f, 4f, step).From(place);
        }

        return (place, velocity);
    }
}
