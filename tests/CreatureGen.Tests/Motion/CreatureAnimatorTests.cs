using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Footsteps;
using Xunit;

namespace CreatureGen.Tests.Motion;

public class CreatureAnimatorTests
{
    private static readonly Creature dog = Walkers.Of(BodyPlan.Digitigrade, 5);

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Fish)]
    public void An_update_allocates_nothing(BodyPlan plan)
    {
        var animator = new CreatureAnimator(Walkers.Of(plan, 5));
        var hills = new Hills(1f, 0.1f);

        Assert.Equal(0, MovingPose.Allocated(Go, 1));

        void Go()
        {
            Walkers.Run(animator, 2f, 60f, new MotionInput(2f, -0.4f), hills);
            Walkers.Run(animator, 1f, 10f, default, hills);
        }
    }

    [Theory]
    [InlineData(MotionDetail.Full)]
    [InlineData(MotionDetail.Far)]
    public void The_same_calls_give_the_same_bits_on_any_thread(MotionDetail detail)
    {
        var profile = new MotionProfile(dog);
        Quaternion[][] poses = new Quaternion[8][];
        Parallel.For(0, poses.Length, i =>
        {
            var animator = new CreatureAnimator(profile);
            MotionSettings settings = animator.Settings;
            settings.Detail = detail;
            animator.Settings = settings;
            Walkers.Run(animator, 1.5f, 60f, new MotionInput(1.2f, 0.4f), FlatGround.Level);
            Walkers.Run(animator, 1f, 37f, new MotionInput(3f), FlatGround.Level);
            poses[i] = animator.ModelPose.Rotations.ToArray();
        });
        for (int i = 1; i < poses.Length; i++)
        {
            Assert.Equal(poses[0], poses[i]);
        }
    }

    [Fact]
    public void Bad_input_is_refused_and_named()
    {
        var animator = new CreatureAnimator(dog);
        Assert.ThrowsAny<ArgumentException>(() => animator.Update(float.NaN, default, FlatGround.Level));
        Assert.ThrowsAny<ArgumentException>(() => animator.Update(-0.1f, default, FlatGround.Level));
        ArgumentException speed = Assert.ThrowsAny<ArgumentException>(() => animator.Update(0.1f, new MotionInput(float.NaN), FlatGround.Level));
        Assert.Contains("Speed", speed.Message);
        Assert.ThrowsAny<ArgumentException>(() => animator.Update(0.1f, new MotionInput(0f, float.PositiveInfinity), FlatGround.Level));
        Assert.Throws<ArgumentNullException>(() => animator.Update(0.1f, default, null!));
        Assert.ThrowsAny<ArgumentException>(() => animator.Rebase(new Vector3(float.NaN, 0f, 0f)));
        Assert.ThrowsAny<ArgumentException>(() => animator.LookAt = new Vector3(0f, float.NaN, 0f));
        MotionSettings settings = MotionSettings.Default;
        settings.Gravity = float.NaN;
        ArgumentException gravity = Assert.ThrowsAny<ArgumentException>(() => animator.Settings = settings);
        Assert.Contains("Gravity", gravity.Message);
    }

    [Theory]
    [InlineData(0.05f)]
    [InlineData(1f)]
    [InlineData(20f)]
    public void A_creature_of_any_size_goes_alike_in_its_own_measure(float scale)
    {
        // By dynamic similarity, speed and time go with the root of the size.
        float root = MathF.Sqrt(scale);
        var small = new CreatureAnimator(dog);
        var large = new CreatureAnimator(dog);
        large.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity, scale), FlatGround.Level);
        small.Teleport(new RootPlace(Vector3.Zero, Quaternion.Identity), FlatGround.Level);
        for (int i = 0; i < 120; i++)
        {
            small.Update(1f / 60f, new MotionInput(1f), FlatGround.Level);
            large.Update(MathF.Min(root / 60f, 0.25f), new MotionInput(root), FlatGround.Level);
        }

        for (int foot = 0; foot < small.FootCount; foot++)
        {
            Assert.True(large.Foot(foot).Residual < 0.01f * large.Profile.LegLength);
        }

        foreach (Quaternion q in large.ModelPose.Rotations)
        {
            Assert.InRange(q.Length(), 0.999f, 1.001f);
        }

        Assert.InRange(large.Root.Position.Z / scale, 0.9f * small.Root.Position.Z, 1.1f * small.Root.Position.Z);
    }

    [Fact]
    public void Any_step_of_time_leaves_a_sound_pose()
    {
        var animator = new CreatureAnimator(dog);
        var random = new CreatureGen.Seeding.RandomStream(7);
        float[] steps = { 0f, 1e-6f, 0.001f, 0.016f, 0.1f, 0.25f, 3f };
        for (int i = 0; i < 400; i++)
        {
            float dt = steps[random.Integer(0, steps.Length - 1)];
            animator.Update(dt, new MotionInput((float)random.Uniform(-2, 12), (float)random.Uniform(-3, 3), (float)random.Uniform(-1, 1)), FlatGround.Level);
            foreach (Quaternion q in animator.ModelPose.Rotations)
            {
                Assert.InRange(q.Length(), 0.999f, 1.001f);
            }

            for (int j = 0; j < animator.ModelPose.Positions.Length; j++)
            {
                Assert.InRange(animator.ModelPose.Positions[j].Length(), 0f, 10f * animator.Profile.LegLength);
            }
        }
    }

    [Fact]
    public void A_pause_changes_nothing()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 1f, 60f, new MotionInput(1f), FlatGround.Level);
        Vector3[] before = animator.ModelPose.Positions.ToArray();
        for (int i = 0; i < 5; i++)
        {
            animator.Update(0f, new MotionInput(1f), FlatGround.Level);
        }

        for (int i = 0; i < before.Length; i++)
        {
            Assert.True(Vector3.Distance(before[i], animator.ModelPose.Positions[i]) < 1e-4f * animator.Profile.LegLength);
        }

        Assert.True(animator.Events.IsEmpty);
    }

    [Fact]
    public void Moving_the_origin_of_the_world_changes_no_pose()
    {
        var still = new CreatureAnimator(dog);
        var moved = new CreatureAnimator(dog);
        var offset = new Vector3(64f, 0f, -32f);
        Walkers.Run(still, 1f, 60f, new MotionInput(1f, 0.2f), FlatGround.Level);
        Walkers.Run(moved, 1f, 60f, new MotionInput(1f, 0.2f), FlatGround.Level);
        moved.Rebase(offset);
        Walkers.Run(still, 0.5f, 60f, new MotionInput(1f, 0.2f), FlatGround.Level);
        Walkers.Run(moved, 0.5f, 60f, new MotionInput(1f, 0.2f), FlatGround.Level);
        Assert.True(Vector3.Distance(still.Root.Position + offset, moved.Root.Position) < 1e-3f);
        for (int i = 0; i < still.ModelPose.Positions.Length; i++)
        {
            Assert.True(Vector3.Distance(still.ModelPose.Positions[i], moved.ModelPose.Positions[i]) < 1e-3f);
        }
    }

    [Fact]
    public void After_a_teleport_it_stands_on_its_feet_there()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 1f, 60f, new MotionInput(2f), FlatGround.Level);
        var place = new RootPlace(new Vector3(500f, 0f, 20f), Rotation.FromAxisAngle(Vector3.UnitY, 2));
        animator.Teleport(place, FlatGround.Level);
        Vector3[] standing = animator.ModelPose.Positions.ToArray();
        animator.Update(1f / 60f, default, FlatGround.Level);
        for (int i = 0; i < animator.FootCount; i++)
        {
            Assert.Equal(FootPhase.Stance, animator.Foot(i).Phase);
            Assert.True(Vector3.Distance(animator.Foot(i).Place, place.Position) < 2f * animator.Profile.LegLength);
        }

        for (int i = 0; i < standing.Length; i++)
        {
            Assert.True(Vector3.Distance(standing[i], animator.ModelPose.Positions[i]) < 0.02f * animator.Profile.LegLength);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Sprawling)]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.ManyLegged)]
    public void Stopping_in_mid_step_puts_every_foot_down_at_home(BodyPlan plan)
    {
        var animator = new CreatureAnimator(Walkers.Of(plan, 3));
        float speed = animator.Profile.Gaits!.Speeds[0].Comfortable;
        Walkers.Run(animator, 2.13f, 60f, new MotionInput(speed), FlatGround.Level);
        for (int i = 0; i < 240 && !Enumerable.Range(0, animator.FootCount).Any(f => animator.Foot(f).Phase == FootPhase.Swing); i++)
        {
            animator.Update(1f / 60f, new MotionInput(speed), FlatGround.Level);
        }

        Assert.Contains(Enumerable.Range(0, animator.FootCount), i => animator.Foot(i).Phase == FootPhase.Swing);
        Walkers.Run(animator, 6f, 60f, default, FlatGround.Level);
        for (int i = 0; i < animator.FootCount; i++)
        {
            FootReport foot = animator.Foot(i);
            Vector3 rest = animator.Profile.Subject.Skeleton.ModelPositions[foot.Joint];
            Vector3 place = animator.Root.ToModel(foot.Place);
            Assert.Equal(FootPhase.Stance, foot.Phase);
            Assert.True(Vector2.Distance(new Vector2(rest.X, rest.Z), new Vector2(place.X, place.Z)) < 0.05f * animator.Profile.LegLength);
        }

        Assert.True(animator.Events.IsEmpty);
    }

    [Theory]
    [InlineData(30f)]
    [InlineData(144f)]
    [InlineData(5f)]
    public void Every_step_is_told_once_down_and_once_up(float rate)
    {
        var animator = new CreatureAnimator(dog);
        var down = new bool[animator.FootCount];
        Array.Fill(down, true);
        int steps = 0;
        int frames = (int)(6f * rate);
        for (int i = 0; i < frames; i++)
        {
            animator.Update(1f / rate, new MotionInput(1.2f, 0.2f), FlatGround.Level);
            foreach (MotionEvent e in animator.Events)
            {
                Assert.Equal(e.Kind == MotionEventKind.FootUp, down[e.Foot]);
                down[e.Foot] = e.Kind == MotionEventKind.FootDown;
                steps += down[e.Foot] ? 1 : 0;
                Assert.InRange(e.SecondsAgo, 0f, (1f / rate) + 1e-4f);
                Assert.True(e.Strength > 0f && e.Position.Y == 0f);
            }

            for (int foot = 0; foot < down.Length; foot++)
            {
                Assert.Equal(down[foot], animator.Foot(foot).Phase == FootPhase.Stance);
            }
        }

        Assert.InRange(steps, (int)(4 * 5f * animator.Frequency * 0.8f), (int)(4 * 6f * animator.Frequency * 1.2f));
    }

    [Fact]
    public void Feet_fall_in_the_same_places_at_any_frame_rate()
    {
        List<Vector3> slow = Prints(30f);
        List<Vector3> middle = Prints(60f);
        List<Vector3> fast = Prints(144f);
        for (int i = 0; i < 24; i++)
        {
            // From standing on within two hundredths of a leg; once the walk is steady, its steps to the millimetre.
            Assert.True(Vector3.Distance(slow[i], fast[i]) < 0.02f * dog.StandingHeight, $"{i}: {slow[i]} {fast[i]}");
            Assert.True(Vector3.Distance(middle[i], fast[i]) < 0.02f * dog.StandingHeight, $"{i}: {middle[i]} {fast[i]}");
            if (i >= 16)
            {
                Assert.True(Vector3.Distance(slow[i] - slow[i - 4], fast[i] - fast[i - 4]) < 1e-3f, $"{i}: {slow[i] - slow[i - 4]} {fast[i] - fast[i - 4]}");
                Assert.True(Vector3.Distance(middle[i] - middle[i - 4], fast[i] - fast[i - 4]) < 1e-3f, $"{i}: {middle[i] - middle[i - 4]} {fast[i] - fast[i - 4]}");
            }
        }

        static List<Vector3> Prints(float rate)
        {
            var animator = new CreatureAnimator(dog);
            var prints = new List<Vector3>();
            int frames = (int)(9 * rate);
            for (int i = 0; i < frames; i++)
            {
                animator.Update(1f / rate, new MotionInput(1.2f), FlatGround.Level);
                foreach (MotionEvent e in animator.Events)
                {
                    if (e.Kind == MotionEventKind.FootDown)
                    {
                        prints.Add(e.Position);
                    }
                }
            }

            return prints;
        }
    }

    [Fact]
    public void Feet_stay_on_a_lift_that_moves_and_the_body_goes_along()
    {
        var animator = new CreatureAnimator(dog);
        var lift = new Lift();
        Walkers.Run(animator, 1f, 60f, default, lift);
        Vector3 root = animator.Root.Position;
        Vector3 foot = animator.Foot(0).Place;
        var way = new Vector3(0.4f, 1.1f, -0.2f);
        for (int i = 1; i <= 60; i++)
        {
            lift.Place = new RootPlace(way * (i / 60f), Quaternion.Identity);
            animator.Update(1f / 60f, default, lift);
        }

        Assert.True(Vector3.Distance(foot + way, animator.Foot(0).Place) < 1e-3f);
        Assert.True(Vector3.Distance(root + way, animator.Root.Position) < 0.02f);
    }

    [Fact]
    public void A_creature_on_a_wall_goes_as_on_the_floor()
    {
        var floor = new CreatureAnimator(dog);
        var wall = new CreatureAnimator(dog);
        MotionSettings settings = MotionSettings.Default;
        settings.Up = -Vector3.UnitZ;
        wall.Settings = settings;
        Quaternion onto = Rotation.FromTo(Vector3.UnitY, -Vector3.UnitZ);
        var ground = new FlatGround(Vector3.Zero, -Vector3.UnitZ);
        wall.Teleport(new RootPlace(Vector3.Zero, onto), ground);
        floor.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(floor, 2f, 60f, new MotionInput(1f), FlatGround.Level);
        Walkers.Run(wall, 2f, 60f, new MotionInput(1f), ground);
        Assert.True(Vector3.Distance(Rotation.Rotate(onto, floor.Root.Position), wall.Root.Position) < 1e-3f);
        for (int i = 0; i < floor.ModelPose.Positions.Length; i++)
        {
            Assert.True(Vector3.Distance(floor.ModelPose.Positions[i], wall.ModelPose.Positions[i]) < 2e-3f);
        }
    }

    [Fact]
    public void A_creature_that_the_game_moves_steps_along()
    {
        var animator = new CreatureAnimator(dog);
        int steps = 0;
        float speed = animator.Profile.Gaits!.Speeds[0].Comfortable;
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        for (int i = 1; i <= 300; i++)
        {
            animator.Follow(1f / 60f, new RootPlace(new Vector3(0f, 0f, speed * i / 60f), Quaternion.Identity), FlatGround.Level);
            steps += animator.Events.Length;
            for (int foot = 0; foot < animator.FootCount; foot++)
            {
                Assert.True(animator.Foot(foot).Phase == FootPhase.Swing || animator.Foot(foot).Residual < 0.02f * animator.Profile.LegLength);
            }
        }

        Assert.True(steps > 16);
        Assert.InRange(animator.Speed, 0.95f * speed, 1.05f * speed);
    }

    [Fact]
    public void It_keeps_to_its_top_speed_and_to_a_gait_that_is_asked_for()
    {
        var animator = new CreatureAnimator(dog);
        Walkers.Run(animator, 5f, 60f, new MotionInput(1000f), FlatGround.Level);
        Assert.InRange(animator.Speed, 0.98f * animator.Profile.Gaits!.TopSpeed, 1.001f * animator.Profile.Gaits.TopSpeed);
        MotionSettings settings = MotionSettings.Default;
        settings.Walking = settings.Walking with { Gait = GaitLibrary.Pace };
        animator.Settings = settings;
        Walkers.Run(animator, 1f, 60f, new MotionInput(2f), FlatGround.Level);
        Assert.Equal("Pace", animator.Gait!.Name);
    }

    [Fact]
    public void Changes_of_gait_do_not_make_the_pose_jump()
    {
        var animator = new CreatureAnimator(dog);
        GaitSet gaits = animator.Profile.Gaits!;
        float[] speeds = { gaits.Speeds[0].Comfortable, gaits.Speeds[1].Comfortable, gaits.TopSpeed * 0.5f, gaits.Speeds[1].Comfortable, 0f };

        // The quickest turn of a joint in each of the gaits by itself.
        float quickest = 0f;
        foreach (float speed in speeds)
        {
            var steady = new CreatureAnimator(animator.Profile);
            Walkers.Run(steady, 4f, 120f, new MotionInput(speed), FlatGround.Level);
            quickest = Math.Max(quickest, Recorded(steady, new[] { speed }).FastestJoint);
        }

        MotionReport report = Recorded(animator, speeds);
        Assert.True(report.FastestJoint < 1.35f * quickest, $"{report.FastestJoint} rad/s, steady {quickest}");
        Assert.True(report.Penetration < 0.01f, $"{report.Penetration}");
        Assert.True(report.Slip < 0.002f, $"{report.Slip}");
        Walkers.Run(animator, 2f, 120f, default, FlatGround.Level);
        Assert.Equal(0f, animator.Speed, 2);

        static MotionReport Recorded(CreatureAnimator animator, float[] speeds)
        {
            var recorder = new MotionRecorder(animator);
            foreach (float speed in speeds)
            {
                for (int i = 0; i < 180; i++)
                {
                    animator.Update(1f / 120f, new MotionInput(speed), FlatGround.Level);
                    recorder.Record(1f / 120f, FlatGround.Level);
                }
            }

            return recorder.Report();
        }
    }
}
