using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Soak;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

/// <summary>An update happens wholly or not at all.</summary>
public sealed class ThrowingGroundTests
{
    private const float Dt = 1f / 30f;

    public static TheoryData<RequestedKind, ulong> Creatures => new()
    {
        { RequestedKind.Walking, 42 }, { RequestedKind.Walking, 1 }, { RequestedKind.Walking, 8 }, { RequestedKind.Flying, 7 }, { RequestedKind.Flying, 2 }, { RequestedKind.Swimming, 3 },
    };

    /// <summary>At each update the ground first throws at its first ray, then at its second, and so on until there are no more: nothing of that can be seen, then or later.</summary>
    [Theory]
    [MemberData(nameof(Creatures))]
    public void After_a_ground_threw_at_any_call_the_creature_is_as_it_was_and_goes_on_bit_for_bit(RequestedKind kind, ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
        AssertSame(profile, Course(profile.Subject.Creature!));
    }

    [Fact]
    public void So_do_creatures_that_crawl()
    {
        Creature snake = CreatureGenerator.Generate(5, CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = BodyPlanWeight.Only(CreatureGen.Anatomy.BodyPlan.Legless) });
        AssertSame(new MotionProfile(snake), Course(snake));
    }

    [Fact]
    public void What_keeps_the_state_allocates_nothing()
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(42));
        var ground = new Interrupted();
        Assert.Equal(0, MovingPose.Allocated(() => animator.Update(Dt, new MotionInput(1f), ground), 60));
    }

    private static void AssertSame(MotionProfile profile, List<Action<CreatureAnimator, IGround>> course)
    {
        var usual = new CreatureAnimator(profile);
        var disturbed = new CreatureAnimator(profile);
        var ground = new Interrupted();
        int thrown = 0;
        for (int i = 0; i < course.Count; i++)
        {
            course[i](usual, new Interrupted());
            byte[] before = Shown(disturbed);
            for (int call = 1; ; call++)
            {
                ground.CallsLeft = call;
                try
                {
                    course[i](disturbed, ground);
                    break;
                }
                catch (InvalidOperationException problem)
                {
                    Assert.Same(HostileGround.Thrown, problem);
                    Assert.True(before.AsSpan().SequenceEqual(Shown(disturbed)), $"step {i}, call {call}: something changed");
                    Assert.True(disturbed.Events.IsEmpty);
                    thrown++;
                }
            }

            Assert.True(Shown(usual).AsSpan().SequenceEqual(Shown(disturbed)), $"step {i} is another after {thrown} exceptions");
            Assert.Equal(usual.Events.Length, disturbed.Events.Length);
        }

        Assert.True(thrown > 40, $"only {thrown}");
    }

    /// <summary>Starts, turns, gaits, flight, stops, a lift, teleports, and being moved by the game.</summary>
    private static List<Action<CreatureAnimator, IGround>> Course(Creature creature)
    {
        float speed = creature.DefaultSpeed;
        var course = new List<Action<CreatureAnimator, IGround>>();
        Go(12, new MotionInput(speed, 0.3f));
        Go(12, new MotionInput(2.5f * speed, -0.4f, 0.1f));
        Go(14, new MotionInput(1.5f * speed, 0.2f, 0f, 0.6f) { Medium = MotionMedium.Air });
        course.Add((animator, ground) => animator.Teleport(new RootPlace(new Vector3(4f, 0.1f, 1f), Quaternion.CreateFromAxisAngle(Vector3.UnitY, 1f)), ground));
        Go(12, new MotionInput(speed));
        for (int i = 0; i < 8; i++)
        {
            course.Add((animator, ground) => animator.Follow(Dt, new RootPlace(animator.Root.ToWorld(new Vector3(0.01f, 0f, 0.8f * speed * Dt)), animator.Root.Rotation), ground));
        }

        Go(12, default);
        return course;

        void Go(int updates, MotionInput input)
        {
            for (int i = 0; i < updates; i++)
            {
                course.Add((animator, ground) => animator.Update(Dt, input, ground));
            }
        }
    }

    /// <summary>All that can be read of an animator but its events, as bytes.</summary>
    private static byte[] Shown(CreatureAnimator animator)
    {
        var bytes = new List<byte>();
        Add<Quaternion>(animator.LocalPose.Rotations);
        Add<Vector3>(animator.LocalPose.Positions);
        Add<Quaternion>(animator.ModelPose.Rotations);
        Add<Vector3>(animator.ModelPose.Positions);
        Add<Vector3>(new[] { animator.Root.Position, new Vector3(animator.Speed, animator.Phase, animator.Frequency) });
        Add<Quaternion>(new[] { animator.Root.Rotation });
        for (int foot = 0; foot < animator.FootCount; foot++)
        {
            FootReport report = animator.Foot(foot);
            Add<Vector3>(new[] { report.Place, report.Normal, new Vector3((float)report.Phase, report.Progress, report.Load) });
        }

        return bytes.ToArray();

        void Add<T>(ReadOnlySpan<T> items)
            where T : struct => bytes.AddRange(MemoryMarshal.AsBytes(items).ToArray());
    }

    /// <summary>Rough ground with a lift, that throws at a call.</summary>
    private sealed class Interrupted : IMovingGround
    {
        /// <summary>The call at which it throws; 0 for never.</summary>
        public int CallsLeft { get; set; }

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            Call();
            float height = 0.04f * (MathF.Sin(3f * origin.X) + MathF.Cos(4f * origin.Z));
            float along = (height - origin.Y) / direction.Y;
            hit = new GroundHit(origin + (direction * along), Vector3.UnitY) { Platform = origin.Z > 0.6f ? 1 : 0 };
            return along <= distance;
        }

        public bool TryLocate(int platform, out RootPlace placement)
        {
            Call();
            placement = RootPlace.Identity;
            return true;
        }

        private void Call()
        {
            if (CallsLeft > 0 && --CallsLeft == 0)
            {
                throw HostileGround.Thrown;
            }
        }
    }
}
