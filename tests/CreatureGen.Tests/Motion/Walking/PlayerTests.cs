using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Walkers under the hands of a player, who asks for another speed and another turn every moment.</summary>
public sealed class PlayerTests
{
    private static readonly float[] unevenSteps = { 0.004f, 0.016f, 0.033f, 0.1f };

    /// <summary>The plans and seeds whose joints were turned fastest or farthest beyond their limits before feet were let go in time.</summary>
    public static TheoryData<BodyPlan, ulong> Walking => new()
    {
        { BodyPlan.Digitigrade, 7000306 },
        { BodyPlan.Unguligrade, 7000301 },
        { BodyPlan.Plantigrade, 7000304 },
        { BodyPlan.Columnar, 7000300 },
        { BodyPlan.Sprawling, 7000301 },
        { BodyPlan.Theropod, 7000302 },
        { BodyPlan.Upright, 7000301 },
        { BodyPlan.Hexapod, 7000300 },
        { BodyPlan.ManyLegged, 7000301 },
        { BodyPlan.Centaur, 7000301 },
    };

    [Theory]
    [MemberData(nameof(Walking))]
    public void Joints_stay_within_their_limits_whatever_is_asked_and_however_long_updates_take(BodyPlan plan, ulong seed)
    {
        var player = new Player(plan, seed);
        for (int i = 0; i < 300; i++)
        {
            float step = player.Hitches() ? 0.25f : unevenSteps[i % unevenSteps.Length];
            player.Update(step);
            float excess = player.LegExcess(out string joint);
            Assert.True(excess < Scalar.Radians(0.3), $"{joint} is {Scalar.Degrees(excess)}° beyond its limit after {player.Seconds} s");
        }
    }

    [Theory]
    [MemberData(nameof(Walking))]
    public void No_joint_of_a_leg_is_hurled_whatever_is_asked(BodyPlan plan, ulong seed)
    {
        const float Step = 1f / 480f;
        var player = new Player(plan, seed);
        player.Update(Step);
        for (int i = 0; i < 4 * 480; i++)
        {
            Quaternion[] before = player.Animator.LocalPose.Rotations.ToArray();
            player.Update(Step);
            float fastest = player.Fastest(before, out string joint) / Step;
            Assert.True(fastest < 75f, $"{joint} turns by {fastest} rad/s after {player.Seconds} s");
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Unguligrade)]
    [InlineData(BodyPlan.Sprawling)]
    [InlineData(BodyPlan.Upright)]
    [InlineData(BodyPlan.ManyLegged)]
    public void In_a_steady_gait_each_foot_leaves_the_ground_once_in_a_cycle(BodyPlan plan)
    {
        var animator = new CreatureAnimator(Walkers.Of(plan, 7000300));
        foreach (GaitSpeed speed in animator.Profile.Gaits!.Speeds)
        {
            var input = new MotionInput(speed.Comfortable);
            Walkers.Run(animator, 4f, 60f, input, FlatGround.Level);
            int cycles = 0;
            int lifts = 0;
            while (cycles < 4)
            {
                float phase = animator.Phase;
                animator.Update(1f / 60f, input, FlatGround.Level);
                cycles += animator.Phase < phase ? 1 : 0;
                lifts += animator.Events.ToArray().Count(e => e.Kind == MotionEventKind.FootUp);
            }

            Assert.InRange(lifts, 3 * animator.FootCount, 5 * animator.FootCount);
        }
    }

    [Fact]
    public void A_walker_speeds_up_and_brakes_by_no_more_than_its_grip_allows()
    {
        foreach (float traction in new[] { 0.3f, 1f })
        {
            var animator = new CreatureAnimator(Walkers.Of(BodyPlan.Digitigrade, 7000300)) { Settings = MotionSettings.Default with { Walking = new WalkingSettings { Traction = traction } } };
            float fastest = 0f;
            for (int i = 0; i < 20 * 60; i++)
            {
                float before = animator.Speed;
                animator.Update(1f / 60f, new MotionInput(i < 600 ? animator.Profile.Gaits!.TopSpeed : 0f), FlatGround.Level);
                fastest = MathF.Max(fastest, MathF.Abs(animator.Speed - before) * 60f);
            }

            Assert.InRange(fastest, 0.5f * 9.81f * traction, 0.701f * 9.81f * traction);
            Assert.Equal(0f, animator.Speed);
        }
    }

    [Fact]
    public void A_creature_of_heft_goes_as_one_so_many_times_as_large()
    {
        var light = new CreatureAnimator(Walkers.Of(BodyPlan.Columnar, 7000300));
        var heavy = new CreatureAnimator(light.Profile) { Settings = MotionSettings.Default with { Walking = WalkingSettings.Default with { Heft = 4f } } };
        float speed = light.Profile.Gaits!.Speeds[0].Comfortable;
        Walkers.Run(light, 4f, 120f, new MotionInput(speed, 0.2f), FlatGround.Level);
        Walkers.Run(heavy, 8f, 60f, new MotionInput(speed / 2f, 0.1f), FlatGround.Level);
        Assert.Equal(light.Frequency / 2f, heavy.Frequency, 3);
        Assert.Equal(light.Speed / 2f, heavy.Speed, 3);
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, 7000300)]
    [InlineData(BodyPlan.Unguligrade, 7000302)]
    [InlineData(BodyPlan.Theropod, 7000305)]
    [InlineData(BodyPlan.Hexapod, 7000304)]
    public void Feet_come_to_rest_in_the_same_places_at_every_frame_rate(BodyPlan plan, ulong seed)
    {
        var profile = new MotionProfile(Walkers.Of(plan, seed));
        CreatureAnimator reference = Play(profile, seed, 480);
        foreach (int rate in new[] { 30, 60, 144 })
        {
            CreatureAnimator animator = Play(profile, seed, rate);
            Assert.True(Vector3.Distance(animator.Root.Position, reference.Root.Position) < 0.01f * profile.LegLength);
            for (int i = 0; i < animator.FootCount; i++)
            {
                float away = Vector3.Distance(animator.Foot(i).Place, reference.Foot(i).Place) / profile.LegLength;
                Assert.True(away < 0.015f, $"foot {i} at {rate} Hz rests {away} leg lengths from where it does at 480 Hz");
            }
        }

        static CreatureAnimator Play(MotionProfile profile, ulong seed, int rate)
        {
            var animator = new CreatureAnimator(profile);
            var hand = new RandomStream(seed);
            for (int half = 0; half < 12; half++)
            {
                var input = new MotionInput((float)hand.Uniform(0, profile.Gaits!.TopSpeed), (float)hand.Uniform(-2, 2));
                Walkers.Run(animator, 0.5f, rate, input, FlatGround.Level);
            }

            Walkers.Run(animator, 4f, rate, default, FlatGround.Level);
            return animator;
        }
    }

    [Theory]
    [InlineData(BodyPlan.Upright, 7000300, 1)]
    [InlineData(BodyPlan.Upright, 7000300, -1)]
    [InlineData(BodyPlan.Upright, 7000301, 1)]
    [InlineData(BodyPlan.Digitigrade, 7000300, 1)]
    public void A_runner_stays_on_stairs(BodyPlan plan, ulong seed, int up)
    {
        var animator = new CreatureAnimator(Walkers.Of(plan, seed));
        float length = animator.Profile.LegLength;
        var stairs = new Stairs(0.55f * length, up * 0.2f * length);
        animator.Teleport(RootPlace.Identity, stairs);
        for (int i = 0; i < 600; i++)
        {
            animator.Update(1f / 60f, new MotionInput(animator.Profile.Gaits!.TopSpeed), stairs);
            float away = MathF.Abs(animator.Root.Position.Y - stairs.HeightAt(animator.Root.Position.Z)) / length;
            Assert.True(away < 1.3f, $"{away} leg lengths from the tread below it after {i} frames");
        }
    }

    [Theory]
    [InlineData(7000300)]
    [InlineData(7000302)]
    public void Feet_of_a_biped_keep_their_places_as_it_leans_into_a_turn(ulong seed)
    {
        var animator = new CreatureAnimator(Walkers.Of(BodyPlan.Theropod, seed));
        float worst = 0f;
        for (int i = 0; i < 360; i++)
        {
            animator.Update(1f / 60f, new MotionInput(animator.Profile.Gaits!.TopSpeed, i > 180 ? 2f : 0f), FlatGround.Level);
            for (int foot = 0; foot < 2; foot++)
            {
                FootReport report = animator.Foot(foot);
                worst = MathF.Max(worst, report.Phase == FootPhase.Stance && i > 240 ? report.Residual : 0f);
            }
        }

        Assert.True(worst < 0.01f * animator.Profile.LegLength, $"{worst} m of {animator.Profile.LegLength}");
    }

    /// <summary>Steps without end from where z is 0.</summary>
    private sealed class Stairs : IGround
    {
        private readonly float tread;
        private readonly float rise;

        public Stairs(float tread, float rise)
        {
            this.tread = tread;
            this.rise = rise;
        }

        public float HeightAt(float z) => rise * MathF.Max(0f, MathF.Floor(z / tread));

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            float height = HeightAt(origin.Z);
            hit = new GroundHit(new Vector3(origin.X, height, origin.Z), Vector3.UnitY);
            return origin.Y >= height && origin.Y - distance <= height;
        }
    }

    /// <summary>A walker and the hand that steers it.</summary>
    private sealed class Player
    {
        private readonly RandomStream hand;
        private readonly float top;
        private float until;
        private MotionInput input;

        public Player(BodyPlan plan, ulong seed)
        {
            Animator = new CreatureAnimator(Walkers.Of(plan, seed));
            hand = new RandomStream(seed);
            top = Animator.Profile.Gaits!.TopSpeed;
        }

        public CreatureAnimator Animator { get; }

        public float Seconds { get; private set; }

        public bool Hitches() => hand.Chance(0.02);

        public void Update(float step)
        {
            if (Seconds >= until)
            {
                until = Seconds + (float)hand.Uniform(0.3, 2.8);
                input = new MotionInput((float)hand.Uniform(0, top), (float)hand.Uniform(-2, 2));
            }

            Animator.Update(step, input, FlatGround.Level);
            Seconds += step;
        }

        public float LegExcess(out string joint)
        {
            joint = string.Empty;
            float max = 0f;
            Skeleton skeleton = Animator.Profile.Subject.Skeleton;
            for (int i = 0; i < skeleton.Count; i++)
            {
                Joint of = skeleton.Joints[i];
                float excess = IsOfLeg(of) ? SwingTwistLimit.Excess(Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(of.LocalRotation), Animator.LocalPose.Rotations[i])), of.Limit) : 0f;
                (max, joint) = excess > max ? (excess, of.Name) : (max, joint);
            }

            return max;
        }

        public float Fastest(Quaternion[] before, out string joint)
        {
            joint = string.Empty;
            float max = 0f;
            Skeleton skeleton = Animator.Profile.Subject.Skeleton;
            for (int i = 0; i < skeleton.Count; i++)
            {
                float turned = IsOfLeg(skeleton.Joints[i]) ? (float)Rotation.Angle(Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(before[i]), Animator.LocalPose.Rotations[i]))) : 0f;
                (max, joint) = turned > max ? (turned, skeleton.Joints[i].Name) : (max, joint);
            }

            return max;
        }

        private static bool IsOfLeg(Joint joint) => joint.Role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball;
    }
}
