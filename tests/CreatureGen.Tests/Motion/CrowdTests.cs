using System;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Tests.Motion.Soak;
using Xunit;

namespace CreatureGen.Tests.Motion;

/// <summary>Many of one creature in one call.</summary>
public class CrowdTests
{
    private const int Members = 7;
    private const float Dt = 1f / 60f;

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Fish)]
    public void Each_member_moves_bit_for_bit_as_an_animator_of_its_own_does(BodyPlan plan)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 5));
        var hills = new Hills(1f, 0.1f);
        var crowd = new Crowd(profile, Members);
        var alone = new CreatureAnimator[Members];
        for (int i = 0; i < Members; i++)
        {
            alone[i] = new CreatureAnimator(profile);
            Prepare(alone[i], i);
            Prepare(crowd[i], i);
        }

        for (int frame = 0; frame < 150; frame++)
        {
            MotionInput[] inputs = Inputs(frame);
            crowd.Update(Dt, inputs, hills);
            for (int i = 0; i < Members; i++)
            {
                alone[i].Update(Dt, inputs[i], hills);
                Assert.True(Shown(alone[i]).AsSpan().SequenceEqual(Shown(crowd[i])), $"member {i} is another in frame {frame}");
                Assert.Equal(alone[i].Events.ToArray(), crowd[i].Events.ToArray());
            }
        }

        static void Prepare(CreatureAnimator animator, int number)
        {
            MotionSettings settings = animator.Settings;
            settings.Detail = number % 3 == 2 ? MotionDetail.Far : MotionDetail.Full;
            animator.Settings = settings;
            animator.Teleport(new RootPlace(new Vector3(3f * number, number % 2, 1f), Quaternion.Identity), new Hills(1f, 0.1f));
            animator.LookAt = number == 1 ? new Vector3(0f, 1f, 5f) : null;
        }
    }

    [Fact]
    public void How_a_crowd_is_shared_out_among_threads_changes_no_bit()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5));
        var whole = new Crowd(profile, Members);
        var shared = new Crowd(profile, Members);
        for (int frame = 0; frame < 90; frame++)
        {
            MotionInput[] inputs = Inputs(frame);
            whole.Update(Dt, inputs, FlatGround.Level);
            Parallel.ForEach(new[] { (0, 3), (3, 1), (4, Members - 4) }, part => shared.Update(part.Item1, Dt, inputs.AsSpan(part.Item1, part.Item2), FlatGround.Level));
        }

        for (int i = 0; i < Members; i++)
        {
            Assert.Equal(Shown(whole[i]), Shown(shared[i]));
        }
    }

    [Fact]
    public void An_update_of_a_crowd_allocates_nothing()
    {
        var crowd = new Crowd(new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5)), Members);
        MotionInput[] inputs = Inputs(0);
        var hills = new Hills(1f, 0.1f);
        Assert.Equal(0, MovingPose.Allocated(() => crowd.Update(Dt, inputs, hills), 60));
    }

    [Fact]
    public void Wrong_calls_are_refused_and_move_nobody()
    {
        var crowd = new Crowd(new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5)), Members);
        crowd.Update(Dt, Inputs(0), FlatGround.Level);
        byte[][] before = Enumerable.Range(0, Members).Select(i => Shown(crowd[i])).ToArray();
        MotionInput[] wrong = Inputs(1);
        wrong[Members - 1] = new MotionInput(float.NaN);

        Assert.Contains("Speed", Assert.ThrowsAny<ArgumentException>(() => crowd.Update(Dt, wrong, FlatGround.Level)).Message, StringComparison.Ordinal);
        Assert.Contains("expected 7", Assert.ThrowsAny<ArgumentException>(() => crowd.Update(Dt, Inputs(1).AsSpan(1), FlatGround.Level)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => crowd.Update(1, Dt, Inputs(1), FlatGround.Level));
        Assert.Throws<ArgumentOutOfRangeException>(() => crowd.Update(-1, Dt, Inputs(1).AsSpan(1), FlatGround.Level));
        Assert.ThrowsAny<ArgumentException>(() => crowd.Update(-Dt, Inputs(1), FlatGround.Level));
        Assert.Throws<ArgumentNullException>(() => crowd.Update(Dt, Inputs(1), null!));
        Assert.Throws<ArgumentOutOfRangeException>(() => crowd[Members]);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Crowd(crowd.Profile, -1));
        Assert.Throws<ArgumentNullException>(() => new Crowd(null!, 1));
        for (int i = 0; i < Members; i++)
        {
            Assert.Equal(before[i], Shown(crowd[i]));
        }
    }

    [Fact]
    public void Where_the_ground_throws_those_before_have_moved_and_nobody_else()
    {
        var crowd = new Crowd(new MotionProfile(Walkers.Of(BodyPlan.Digitigrade, 5)), Members);
        MotionInput[] inputs = Inputs(0);
        var ground = new Gap(2.5f * Members);
        for (int i = 0; i < Members; i++)
        {
            crowd[i].Teleport(new RootPlace(new Vector3(5f * i, 0f, 0f), Quaternion.Identity), FlatGround.Level);
        }

        crowd.Update(Dt, inputs, FlatGround.Level);
        byte[][] before = Enumerable.Range(0, Members).Select(i => Shown(crowd[i])).ToArray();
        Assert.Same(HostileGround.Thrown, Assert.Throws<InvalidOperationException>(() => crowd.Update(Dt, inputs, ground)));
        for (int i = 0; i < Members; i++)
        {
            Assert.Equal(5f * i > ground.From, before[i].AsSpan().SequenceEqual(Shown(crowd[i])));
        }
    }

    private static MotionInput[] Inputs(int frame) => Enumerable.Range(0, Members)
        .Select(i => new MotionInput(0.4f * ((i + (frame / 40)) % Members), 0.1f * (i - 3), Medium: i % 2 == 0 ? MotionMedium.Air : MotionMedium.Ground)).ToArray();

    private static byte[] Shown(CreatureAnimator animator) => MemoryMarshal.AsBytes(animator.LocalPose.Rotations).ToArray()
        .Concat(MemoryMarshal.AsBytes(animator.ModelPose.Rotations).ToArray())
        .Concat(MemoryMarshal.AsBytes(animator.ModelPose.Positions).ToArray())
        .Concat(MemoryMarshal.AsBytes(new[] { animator.Root }.AsSpan()).ToArray()).ToArray();

    /// <summary>Level ground that cannot be asked beyond a place.</summary>
    private sealed class Gap(float from) : IGround
    {
        public float From => from;

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit) => origin.X > from ? throw HostileGround.Thrown : FlatGround.Level.Cast(origin, direction, distance, out hit);
    }
}
