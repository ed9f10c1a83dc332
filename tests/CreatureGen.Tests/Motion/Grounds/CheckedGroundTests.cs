using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using Xunit;

namespace CreatureGen.Tests.Motion.Grounds;

/// <summary>The boundary of motion: what comes from the game is right, or is refused, or counts as nothing.</summary>
public sealed class CheckedGroundTests
{
    public static TheoryData<float, float, float, float, float, float> NoHits => new()
    {
        { float.NaN, 0, 0, 0, 1, 0 },
        { 0, 0, 0, 0, float.NaN, 0 },
        { 0, 0, 0, 0, float.PositiveInfinity, 0 },
        { 0, 0, 0, 0, 0, 0 },
        { 0, 0, 0, 0, 2, 0 },
        { 0, float.NegativeInfinity, 0, 0, 1, 0 },
        { 1e6f, 0, 0, 0, 1, 0 },
    };

    [Theory]
    [MemberData(nameof(NoHits))]
    public void A_hit_that_is_none_counts_as_none_and_is_counted(float x, float y, float z, float nx, float ny, float nz)
    {
        var hit = new GroundHit(new Vector3(x, y, z), new Vector3(nx, ny, nz));
        Creature creature = CreatureGenerator.Generate(42);
        var lied = new CreatureAnimator(creature);
        var without = new CreatureAnimator(creature);
        for (int i = 0; i < 60; i++)
        {
            lied.Update(1f / 60f, new MotionInput(1f), new Answering((origin, _, _) => hit));
            without.Update(1f / 60f, new MotionInput(1f), new Answering((_, _, _) => null));
            Assert.True(lied.RefusedHits > 0);
            Assert.Equal(0, without.RefusedHits);
        }

        Assert.Equal(without.Root.Position, lied.Root.Position);
        Assert.True(without.ModelPose.Rotations.SequenceEqual(lied.ModelPose.Rotations));
    }

    [Theory]
    [InlineData(1e20f, 0, 0, 0)]
    [InlineData(-1e20f, 0, 0, 0)]
    [InlineData(0, 2000f, 0, 0)]
    [InlineData(0, 0, 20000f, 0)]
    [InlineData(0, 0, 0, float.NaN)]
    [InlineData(float.PositiveInfinity, 0, 0, 0)]
    public void Input_out_of_its_range_is_refused_and_changes_nothing(float speed, float yaw, float sideways, float climb)
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(42));
        animator.Update(0.02f, new MotionInput(1f), FlatGround.Level);
        Quaternion[] before = animator.ModelPose.Rotations.ToArray();
        Vector3 root = animator.Root.Position;
        Assert.ThrowsAny<ArgumentException>(() => animator.Update(0.02f, new MotionInput(speed, yaw, sideways, climb), FlatGround.Level));
        Assert.ThrowsAny<ArgumentException>(() => animator.LookAt = new Vector3(1e20f, 0, 0));
        Assert.ThrowsAny<ArgumentException>(() => new RootPlace(new Vector3(0, 1e20f, 0), Quaternion.Identity));
        Assert.Equal(root, animator.Root.Position);
        Assert.True(animator.ModelPose.Rotations.SequenceEqual(before));
    }

    /// <summary>It gave back rotations that were none.</summary>
    [Theory]
    [InlineData(2f)]
    [InlineData(0.5f)]
    [InlineData(0f)]
    public void A_hinge_that_is_not_unit_is_refused(float length)
    {
        Assert.Throws<ArgumentException>("hinge", () => TwoBoneIk.Solve(Vector3.Zero, Vector3.UnitY, new Vector3(0, 2, 0.2f), Vector3.UnitX * length, new Vector3(0, 1, 1), Vector3.UnitZ, Reach.Default, out _, out _));
    }

    /// <summary>Ground that a test answers for.</summary>
    private sealed class Answering(Func<Vector3, Vector3, float, GroundHit?> answer) : IGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            GroundHit? found = answer(origin, direction, distance);
            hit = found ?? default;
            return found.HasValue;
        }
    }
}
