using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion;

public class DistantMotionTests
{
    private static readonly MotionProfile dog = new(Walkers.Of(BodyPlan.Digitigrade, 5));

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Hexapod)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Flapping)]
    [InlineData(BodyPlan.Fish)]
    public void An_update_from_afar_allocates_nothing_and_neither_does_a_change_of_detail(BodyPlan plan)
    {
        CreatureAnimator animator = Afar(new MotionProfile(Walkers.Of(plan, 5)));
        var hills = new Hills(1f, 0.1f);

        Assert.Equal(0, MovingPose.Allocated(Go, 1));

        void Go()
        {
            See(animator, MotionDetail.Far);
            Walkers.Run(animator, 2f, 60f, new MotionInput(2f, -0.4f), hills);
            See(animator, MotionDetail.Full);
            Walkers.Run(animator, 1f, 60f, new MotionInput(2f), hills);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Hexapod)]
    public void It_goes_the_same_way_from_afar(BodyPlan plan)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 5));
        var near = new CreatureAnimator(profile);
        CreatureAnimator far = Afar(profile);
        float speed = profile.Gaits!.Speeds[0].Comfortable;
        foreach (MotionInput asked in new[] { new MotionInput(speed), new MotionInput(2f * speed, 0.5f), new MotionInput(0f, -1f), default })
        {
            Walkers.Run(near, 2f, 60f, asked, FlatGround.Level);
            Walkers.Run(far, 2f, 60f, asked, FlatGround.Level);
            Assert.InRange(Vec.Distance(near.Root.Position, far.Root.Position), 0f, 0.05f * profile.LegLength);
            Assert.InRange(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(near.Root.Rotation), far.Root.Rotation)), 0f, 0.05f);
            Assert.Same(near.Gait, far.Gait);
        }
    }

    [Theory]
    [InlineData(4f)]
    [InlineData(15f)]
    [InlineData(144f)]
    public void How_long_updates_are_changes_neither_way_nor_place_in_the_cycle(float rate)
    {
        CreatureAnimator often = Afar(dog);
        CreatureAnimator seldom = Afar(dog);
        float speed = dog.Gaits!.Speeds[0].Comfortable;
        Walkers.Run(often, 8f, 60f, new MotionInput(speed), FlatGround.Level);
        Walkers.Run(seldom, 8f, rate, new MotionInput(speed), FlatGround.Level);
        Assert.InRange(Vec.Distance(often.Root.Position, seldom.Root.Position), 0f, 0.02f * dog.LegLength);
        float apart = Math.Abs(often.Phase - seldom.Phase);
        Assert.InRange(Math.Min(apart, 1f - apart), 0f, 0.2f);
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, 0f)]
    [InlineData(BodyPlan.Digitigrade, 0.3f)]
    [InlineData(BodyPlan.Theropod, 0f)]
    [InlineData(BodyPlan.Theropod, 0.15f)]
    [InlineData(BodyPlan.Hexapod, 0.3f)]
    public void Its_lowest_skin_is_at_the_ground_from_afar(BodyPlan plan, float slope)
    {
        Creature creature = Walkers.Of(plan, 5);
        var profile = new MotionProfile(creature);
        CreatureAnimator animator = Afar(profile);
        Vector3 normal = Vec.Normalize(new Vector3(0.3f * slope, 1f, -slope));
        var ground = new FlatGround(Vector3.Zero, normal);
        animator.Teleport(animator.Root, ground);
        See(animator, MotionDetail.Far);
        Walkers.Run(animator, 3f, 60f, new MotionInput(profile.Gaits!.Speeds[0].Comfortable, 0.2f), ground);
        var skin = new Vector3[creature.Mesh.Positions.Length];
        var normals = new Vector3[skin.Length];
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        for (int frame = 0; frame < 60; frame++)
        {
            animator.Update(1f / 60f, new MotionInput(profile.Gaits.Speeds[0].Comfortable, 0.2f), ground);
            SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
            CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, skin, normals);
            float lowest = skin.Min(p => Vec.Dot(animator.Root.ToWorld(p), normal));
            Assert.InRange(lowest / profile.LegLength, -0.12f, 0.06f);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Theropod)]
    [InlineData(BodyPlan.Legless)]
    [InlineData(BodyPlan.Fish)]
    public void Poses_do_not_jump_where_the_detail_changes(BodyPlan plan)
    {
        var profile = new MotionProfile(Walkers.Of(plan, 5));
        CreatureAnimator animator = Afar(profile);
        See(animator, MotionDetail.Full);
        var asked = new MotionInput(profile.Gaits?.Speeds[0].Comfortable ?? 0.5f);
        Walkers.Run(animator, 3f, 60f, asked, FlatGround.Level);
        double usual = Fastest(animator, 60, asked);
        for (int change = 0; change < 8; change++)
        {
            See(animator, change % 2 == 0 ? MotionDetail.Far : MotionDetail.Full);
            Assert.InRange(Fastest(animator, 33, asked), 0, (2.5 * usual) + 0.1);
        }
    }

    [Fact]
    public void It_walks_on_in_full_where_it_was_seen_from_afar()
    {
        CreatureAnimator animator = Afar(dog);
        float speed = dog.Gaits!.Speeds[0].Comfortable;
        Walkers.Run(animator, 3f, 15f, new MotionInput(speed), FlatGround.Level);
        float at = animator.Root.Position.Z;
        See(animator, MotionDetail.Full);
        animator.Update(1f / 60f, new MotionInput(speed), FlatGround.Level);
        Assert.InRange((animator.Root.Position.Z - at) * 60f, 0.95f * speed, 1.05f * speed);
        MotionReport report = Walkers.Measure(animator, 240, 60f, new MotionInput(speed), FlatGround.Level);
        Assert.InRange(report.Slip ?? 1f, 0f, 0.02f * dog.LegLength);
    }

    [Fact]
    public void Acts_jumps_blows_and_falls_are_shown_in_full_and_then_it_is_seen_from_afar_again()
    {
        CreatureAnimator animator = Afar(dog);
        Walkers.Run(animator, 1f, 60f, default, FlatGround.Level);
        Assert.Equal(ActStatus.Started, animator.Perform("Shake").Status);
        Walkers.Run(animator, 1f, 60f, default, FlatGround.Level);
        Assert.NotNull(animator.Act);
        Walkers.Run(animator, 10f, 60f, default, FlatGround.Level);
        Assert.Null(animator.Act);
        var near = new CreatureAnimator(dog);
        near.Teleport(animator.Root, FlatGround.Level);
        Vector3 there = animator.Root.Position + new Vector3(0f, 0f, dog.LegLength);
        Assert.Equal(JumpResult.Begun, near.Jump(there));
        Assert.Equal(JumpResult.Begun, animator.Jump(there));
        Walkers.Run(near, 3f, 60f, default, FlatGround.Level);
        Walkers.Run(animator, 3f, 60f, default, FlatGround.Level);
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.InRange(Vec.Distance(animator.Root.Position, near.Root.Position), 0f, 0.1f * dog.LegLength);
        animator.GoLimp();
        Walkers.Run(animator, 1f, 60f, default, FlatGround.Level);
        Assert.Equal(BodyState.Limp, animator.State);
        Assert.True(animator.GetUp());
        Walkers.Run(animator, 10f, 60f, default, FlatGround.Level);
        Assert.Equal(BodyState.Supported, animator.State);
        animator.Update(1f / 60f, new MotionInput(1f), FlatGround.Level);
        Assert.Equal(0, animator.Events.Length);
    }

    [Fact]
    public void It_falls_where_the_ground_ends()
    {
        CreatureAnimator animator = Afar(dog);
        var shelf = new Shelf(1f);
        Walkers.Run(animator, 4f, 60f, new MotionInput(1.5f), shelf);
        Assert.Equal(BodyState.Falling, animator.State);
        Assert.True(animator.Root.Position.Y < -1f);
    }

    [Fact]
    public void It_swims_where_it_comes_to_deep_water()
    {
        CreatureAnimator animator = Afar(dog);
        float leg = dog.LegLength;
        var lake = new WaterGround(new FlatGround(Vector3.Zero, Vector3.Normalize(new Vector3(0f, 1f, 0.15f))), Vector3.Zero, Vector3.UnitY);
        animator.Teleport(new RootPlace(new Vector3(0f, 0.3f * leg, -2f * leg), Quaternion.Identity), lake);
        for (int i = 0; i < 1800 && animator.State != BodyState.Afloat; i++)
        {
            animator.Update(1f / 60f, new MotionInput(MathF.Sqrt(9.81f * leg)), lake);
        }

        Assert.Equal(BodyState.Afloat, animator.State);
        Assert.True(animator.Root.Position.Z > 0f, "it swims ashore");
    }

    [Fact]
    public void Where_the_ground_throws_nothing_has_changed()
    {
        CreatureAnimator animator = Afar(dog);
        Walkers.Run(animator, 1f, 60f, new MotionInput(1f), FlatGround.Level);
        RootPlace root = animator.Root;
        float phase = animator.Phase;
        Quaternion[] pose = animator.LocalPose.Rotations.ToArray();
        Assert.Throws<InvalidOperationException>(() => animator.Update(0.1f, new MotionInput(3f), new Broken()));
        Assert.Equal(root, animator.Root);
        Assert.Equal(phase, animator.Phase);
        Assert.Equal(pose, animator.LocalPose.Rotations.ToArray());
    }

    [Fact]
    public void What_the_game_moves_goes_along_from_afar()
    {
        CreatureAnimator animator = Afar(dog);
        float speed = dog.Gaits!.Speeds[0].Comfortable;
        for (int i = 1; i <= 120; i++)
        {
            animator.Follow(1f / 60f, new RootPlace(new Vector3(0f, 0f, i * speed / 60f), Quaternion.Identity), FlatGround.Level);
        }

        Assert.InRange(animator.Speed, 0.98f * speed, 1.02f * speed);
        Assert.Equal(2f * speed, animator.Root.Position.Z, 3);
        Assert.Equal(0, animator.Events.Length);
    }

    [Fact]
    public void A_detail_that_there_is_not_is_refused_and_named()
    {
        var animator = new CreatureAnimator(dog);
        MotionSettings settings = animator.Settings;
        settings.Detail = (MotionDetail)7;
        Assert.Contains("Detail", Assert.ThrowsAny<ArgumentException>(() => animator.Settings = settings).Message);
    }

    private static CreatureAnimator Afar(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        See(animator, MotionDetail.Far);
        return animator;
    }

    private static void See(CreatureAnimator animator, MotionDetail detail)
    {
        MotionSettings settings = animator.Settings;
        settings.Detail = detail;
        animator.Settings = settings;
    }

    /// <summary>The farthest that a joint turns from one update to the next, radians.</summary>
    private static double Fastest(CreatureAnimator animator, int updates, MotionInput asked)
    {
        double most = 0;
        Quaternion[] before = animator.LocalPose.Rotations.ToArray();
        for (int i = 0; i < updates; i++)
        {
            animator.Update(1f / 60f, asked, FlatGround.Level);
            for (int joint = 0; joint < before.Length; joint++)
            {
                if (animator.Profile.Subject.Skeleton.Joints[joint].Role != CreatureGen.Rigging.JointRole.Lid)
                {
                    most = Math.Max(most, MovingPose.Between(before[joint], animator.LocalPose.Rotations[joint]));
                }
            }

            before = animator.LocalPose.Rotations.ToArray();
        }

        return most;
    }

    /// <summary>Level ground up to a distance ahead, and nothing beyond.</summary>
    private sealed class Shelf(float end) : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            hit = new GroundHit(new Vector3(origin.X, 0f, origin.Z), Vector3.UnitY);
            return origin.Z < end && origin.Y <= distance && origin.Y >= 0f;
        }
    }

    private sealed class Broken : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit) => throw new InvalidOperationException("no ground today");
    }
}
