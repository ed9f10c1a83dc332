using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Seeking;

public sealed class SeekTests
{
    private const float Step = 1f / 30f;

    [Theory]
    [InlineData(RequestedKind.Walking, MotionMedium.Ground)]
    [InlineData(RequestedKind.Flying, MotionMedium.Air, Explicit = true)]
    [InlineData(RequestedKind.Swimming, MotionMedium.Ground, Explicit = true)]
    public void Creatures_of_all_sizes_come_up_to_a_target_and_stop_before_it(RequestedKind kind, MotionMedium medium)
    {
        for (ulong seed = 1; seed <= 8; seed++)
        {
            (MotionProfile profile, float size) = Grow(kind, seed);
            SeekSettings settings = SeekSettings.For(profile, medium);
            Assert.Equal(kind != RequestedKind.Walking, settings.ClimbSpeed > 0f);
            Assert.InRange(settings.Far, 0.3f * size, 1.5f * size);
            Vector3 target = Target(kind, seed, size);
            CreatureAnimator animator = Sent(profile, settings, medium, target, out float speed);
            float left = Distance(animator, settings, target);
            Assert.True(left > settings.Near - (0.1f * size) && left < settings.Far + (0.1f * size), $"{kind} {seed}: {left} of {settings.Near} to {settings.Far}, size {size}");
            Assert.True(speed < 0.1f * size, $"{kind} {seed}: still {speed} m/s");
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking, MotionMedium.Ground)]
    [InlineData(RequestedKind.Flying, MotionMedium.Air, Explicit = true)]
    [InlineData(RequestedKind.Swimming, MotionMedium.Ground, Explicit = true)]
    public void Creatures_that_are_to_arrive_stop_on_their_target(RequestedKind kind, MotionMedium medium)
    {
        for (ulong seed = 11; seed <= 18; seed++)
        {
            (MotionProfile profile, float size) = Grow(kind, seed);
            SeekSettings settings = SeekSettings.For(profile, medium).Arriving(0.2f * size);
            Vector3 target = Target(kind, seed, size);
            CreatureAnimator animator = Sent(profile, settings, medium, target, out float speed);
            float left = Distance(animator, settings, target);
            Assert.True(left < 0.3f * size, $"{kind} {seed}: {left} of {size}");
            Assert.True(speed < 0.1f * size, $"{kind} {seed}: still {speed} m/s");
        }
    }

    [Fact]
    public void A_fish_whose_target_lies_under_the_terrain_stays_above_it()
    {
        for (ulong seed = 1; seed <= 6; seed++)
        {
            (MotionProfile profile, float size) = Grow(RequestedKind.Swimming, seed);
            SeekSettings settings = SeekSettings.For(profile);
            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(new Vector3(0f, 2f * size, 0f), Quaternion.Identity), FlatGround.Level);
            SeekState state = default;
            for (int i = 0; i < 30 * 30; i++)
            {
                animator.Update(Step, MotionInput.From(Seek.Decide(ref state, settings, animator.Root, new Vector3(3f * size, -3f * size, 5f * size))), FlatGround.Level);
                for (int joint = 1; joint < profile.Subject.Skeleton.Count; joint++)
                {
                    Assert.True(animator.Root.ToWorld(animator.ModelPose.Positions[joint]).Y > -0.1f * size, $"{seed}: joint {joint} at {i}");
                }
            }
        }
    }

    [Fact]
    public void A_creature_twice_as_large_in_the_world_keeps_twice_the_distance()
    {
        (MotionProfile profile, _) = Grow(RequestedKind.Walking, 3);
        SeekSettings one = SeekSettings.For(profile);
        SeekSettings two = SeekSettings.For(profile, MotionMedium.Ground, 2f);
        Assert.Equal(2f * one.Far, two.Far, 4);
        Assert.True(two.TurnSpeed <= one.TurnSpeed);
        SeekState state = default;
        var place = new RootPlace(new Vector3(1f, 0f, 1f), Quaternion.Identity, 2f);
        Assert.Equal(SeekAct.Hold, Doing(place.Position + new Vector3(0f, 0f, 0.5f * (two.Near + two.Far))));
        Assert.Equal(SeekAct.Approach, Doing(place.Position + new Vector3(0f, 0f, 1.1f * two.Far)));

        SeekAct Doing(Vector3 target)
        {
            Seek.Decide(ref state, two, place, target);
            return state.Doing;
        }
    }

    [Fact]
    public void A_velocity_becomes_an_input_within_its_ranges()
    {
        MotionInput input = MotionInput.From(new BodyVelocity(new Vector3(1f, 2f, 3f), 0.5f), MotionMedium.Air);
        Assert.Equal(new MotionInput(3f, 0.5f, 1f, 2f, MotionMedium.Air), input);
        Assert.Equal(1e4f, MotionInput.From(new BodyVelocity(new Vector3(0f, 0f, 1e9f), 0f)).Speed);
        Assert.Throws<ArgumentException>(() => MotionInput.From(new BodyVelocity(new Vector3(float.NaN, 0f, 0f), 0f)));
    }

    private static (MotionProfile Profile, float Size) Grow(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        float front = 0f;
        float rear = 0f;
        foreach (Joint joint in creature.Skeleton.Joints)
        {
            front = Math.Max(front, joint.ModelPosition.Z);
            rear = Math.Min(rear, joint.ModelPosition.Z);
        }

        return (new MotionProfile(creature), front - rear);
    }

    /// <summary>Six lengths away, in a direction of the seed's; above or below for those that climb.</summary>
    private static Vector3 Target(RequestedKind kind, ulong seed, float size)
    {
        double angle = 2.1 * seed;
        float up = kind == RequestedKind.Walking ? 0f : (4f + (2f * ((seed % 3) - 1f))) * size;
        return new Vector3((float)(6 * size * Math.Sin(angle)), up, (float)(6 * size * Math.Cos(angle)));
    }

    /// <summary>The animator after a minute and a half of seeking, and its mean speed in the last two seconds.</summary>
    private static CreatureAnimator Sent(MotionProfile profile, SeekSettings settings, MotionMedium medium, Vector3 target, out float speed)
    {
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, settings.ClimbSpeed > 0f ? 0.7f * target.Y : 0f, 0f), Quaternion.Identity), FlatGround.Level);
        SeekState state = default;
        Vector3 before = default;
        for (int i = 0; i < 90 * 30; i++)
        {
            before = i == 88 * 30 ? animator.Root.Position : before;
            animator.Update(Step, MotionInput.From(Seek.Decide(ref state, settings, animator.Root, target), medium), FlatGround.Level);
        }

        speed = Vector3.Distance(before, animator.Root.Position) / 2f;
        return animator;
    }

    private static float Distance(CreatureAnimator animator, SeekSettings settings, Vector3 target)
    {
        Vector3 left = target - animator.Root.Position;
        left.Y = settings.ClimbSpeed > 0f ? left.Y : 0f;
        return left.Length();
    }

    [Fact]
    public void A_decided_velocity_asks_for_the_same_ahead_aside_up_and_around_within_what_an_input_may_ask()
    {
        var velocity = new BodyVelocity(new Vector3(0.5f, -0.25f, 3f), 0.75f);
        Assert.Equal(new MotionInput(3f, 0.75f, 0.5f, -0.25f, MotionMedium.Air), MotionInput.From(velocity, MotionMedium.Air));
        Assert.Equal(new MotionInput(-10_000f, 1_000f, 10_000f, 10_000f), MotionInput.From(new BodyVelocity(new Vector3(1e9f, 1e9f, -1e9f), 1e9f)));
        Assert.Throws<ArgumentException>(() => MotionInput.From(new BodyVelocity(new Vector3(0f, float.NaN, 0f), 0f)));
        Assert.Throws<ArgumentException>(() => MotionInput.From(new BodyVelocity(Vector3.Zero, float.PositiveInfinity)));
    }
}
