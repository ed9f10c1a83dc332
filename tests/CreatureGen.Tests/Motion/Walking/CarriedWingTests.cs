using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>Wings of creatures that walk and do not fly.</summary>
public sealed class CarriedWingTests
{
    private static readonly CreatureOptions walking = CreatureOptions.Default with { Kind = RequestedKind.Walking };

    /// <summary>Seeds of walkers on four and six legs whose feathers are spread at rest: hooves, paws, sprawlers.</summary>
    public static TheoryData<ulong> Feathered => [9985000, 9985013, 9985064, 9985126, 9985128, 9985142];

    /// <summary>Those with membranes: hooves, pillars, sprawlers, a centaur.</summary>
    public static TheoryData<ulong> Membraned => [9985022, 9985025, 9985026, 9985040, 9985042, 9985055, 9985059, 9985097, 9985204];

    [Theory]
    [MemberData(nameof(Feathered))]
    public void Feathers_lie_along_the_flanks_within_the_limits_of_their_joints(ulong seed) => AreDrawnIn(seed, 0.75f);

    [Theory]
    [MemberData(nameof(Membraned))]
    public void Membranes_are_held_half_closed_within_the_limits_of_their_joints(ulong seed) => AreDrawnIn(seed, 0.85f);

    /// <summary>Laid back with their bones, membranes stood up behind their leading edges like tents.</summary>
    [Theory]
    [MemberData(nameof(Membraned))]
    public void Skin_of_raised_membranes_goes_back_rather_than_up(ulong seed)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        Vector3[] skin = SkinOf(creature, animator);
        foreach (LimbChain wing in LeftWings(creature))
        {
            int[] blade = Enumerable.Range(0, skin.Length).Where(v => creature.Mesh.Weights[v].Joint0 == wing.Joints[1]).OrderBy(v => creature.Mesh.Positions[v].Z).ToArray();
            Vector3 way = Middle(blade[..(blade.Length / 4)]) - Middle(blade[^(blade.Length / 4)..]);
            Assert.True(-way.Z > way.Y, FormattableString.Invariant($"{seed}: from its leading to its trailing edge the forearm's blade goes {way}"));
        }

        Vector3 Middle(int[] some) => some.Aggregate(Vector3.Zero, (sum, v) => sum + skin[v]) / some.Length;
    }

    /// <summary>Folded on a flank they were rags.</summary>
    [Theory]
    [MemberData(nameof(Membraned))]
    public void Membranes_are_held_over_the_back_standing_and_going(ulong seed)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        float standing = HandOverChest(creature, animator);
        Walkers.Run(animator, 4f, 60f, new MotionInput(animator.Profile.Gaits!.Speeds[0].Comfortable), FlatGround.Level);
        float going = HandOverChest(creature, animator);
        Assert.True(standing > 0f && going > 0f, $"{seed}: the hand is {standing} m above the chest standing, {going} m going");
    }

    /// <summary>Hung from the shoulder and drawn together to a quarter of their length, feathers were stumps of arms.</summary>
    [Theory]
    [MemberData(nameof(Feathered))]
    public void Feathers_of_folded_wings_lie_along_the_flank(ulong seed)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        Vector3[] skin = SkinOf(creature, animator);
        foreach (LimbChain wing in LeftWings(creature))
        {
            Vector3[] blade = Enumerable.Range(0, skin.Length).Where(v => wing.Joints.Contains(creature.Mesh.Weights[v].Joint0)).Select(v => skin[v]).ToArray();
            float length = blade.Max(p => p.Z) - blade.Min(p => p.Z);
            float height = blade.Max(p => p.Y) - blade.Min(p => p.Y);
            Assert.True(length > 1.3f * height, FormattableString.Invariant($"{seed}: {length} m long, {height} m high"));
        }
    }

    [Theory]
    [MemberData(nameof(Feathered))]
    public void Who_threatens_spreads_its_feathers_and_folds_them_again(ulong seed) => ShowsItsWings(seed, 1.15f);

    [Theory]
    [MemberData(nameof(Membraned))]
    public void Who_threatens_spreads_its_membranes_farther_and_draws_them_in_again(ulong seed) => ShowsItsWings(seed, 1.03f);

    /// <summary>Folded on its way too they were rags before its forelegs.</summary>
    [Theory]
    [MemberData(nameof(Feathered))]
    public void Who_goes_raises_its_feathers_over_the_back_and_folds_them_again_where_it_stands(ulong seed)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        float folded = Breadth(creature, SkinOf(creature, animator));
        float low = Elevation(creature, animator, JointsOf(creature).First());
        Walkers.Run(animator, 4f, 60f, new MotionInput(animator.Profile.Gaits!.Speeds[0].Comfortable), FlatGround.Level);
        float over = HandOverChest(creature, animator);
        float high = Elevation(creature, animator, JointsOf(creature).First());
        Walkers.Run(animator, 12f, 60f, default, FlatGround.Level);
        float again = Breadth(creature, SkinOf(creature, animator));
        Assert.True(high > low + 0.3f, $"{seed}: the arm points up by {low} rad folded, by {high} rad on its way");
        Assert.True(over > 0f, $"{seed}: the hand is {over} m above the chest");
        Assert.True(Math.Abs(again - folded) < 0.05f * folded, $"{seed}: {folded} m to the side folded, {again} m afterwards");
    }

    [Fact]
    public void Wings_swing_with_the_steps_at_every_frame_rate_alike()
    {
        (Creature creature, CreatureAnimator animator) = Standing(9985013);
        float speed = new MotionProfile(creature).Gaits!.Speeds[0].Comfortable;
        (float Least, float Most) coarse = SwingAt(60f);
        (float Least, float Most) fine = SwingAt(240f);
        Assert.InRange(coarse.Most - coarse.Least, 0.02f, 0.4f);
        Assert.Equal(fine.Most, coarse.Most, 0.02f);
        Assert.Equal(fine.Least, coarse.Least, 0.02f);

        (float, float) SwingAt(float rate)
        {
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            int shoulder = JointsOf(creature).First();
            Walkers.Run(animator, 4f, rate, new MotionInput(speed), FlatGround.Level);
            float least = float.MaxValue;
            float most = float.MinValue;
            for (int i = 0; i < 2 * rate; i++)
            {
                animator.Update(1f / rate, new MotionInput(speed), FlatGround.Level);
                float angle = Elevation(creature, animator, shoulder);
                least = Math.Min(least, angle);
                most = Math.Max(most, angle);
            }

            return (least, most);
        }
    }

    [Fact]
    public void Wings_rise_in_braking_and_the_outer_one_in_a_turn()
    {
        (Creature creature, CreatureAnimator animator) = Standing(9985013);
        float run = animator.Profile.Gaits!.Speeds[^1].Comfortable;
        int left = JointsOf(creature).First();
        int right = creature.Skeleton.Mirrors[left];
        Walkers.Run(animator, 4f, 60f, new MotionInput(run), FlatGround.Level);
        float steady = Most(left, new MotionInput(run));
        float braking = Most(left, default);
        Walkers.Run(animator, 4f, 60f, new MotionInput(run), FlatGround.Level);
        Walkers.Run(animator, 1.5f, 60f, new MotionInput(run, 2f), FlatGround.Level);
        float outer = Most(right, new MotionInput(run, 2f));
        float inner = Most(left, new MotionInput(run, 2f));
        Assert.True(braking > steady + 0.05f, $"{steady} rad at a run, {braking} rad in braking");
        Assert.True(outer > inner + 0.03f, $"{inner} rad inside the turn, {outer} rad outside");

        float Most(int shoulder, MotionInput input)
        {
            float most = float.MinValue;
            for (int i = 0; i < 60; i++)
            {
                animator.Update(1f / 60f, input, FlatGround.Level);
                most = Math.Max(most, Elevation(creature, animator, shoulder));
            }

            return most;
        }
    }

    [Fact]
    public void Wings_that_are_grown_along_the_flank_stay_as_they_are()
    {
        Creature bird = CreatureGenerator.Generate(9985006, walking);
        LimbChain wing = bird.Limbs.First(limb => limb.Kind == LimbKind.Wing);
        Assert.False(SpreadWings.Is(bird.Skeleton, wing));
        Assert.Null(new MotionProfile(bird).Wings);
    }

    private static void AreDrawnIn(ulong seed, float most)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        float rest = Breadth(creature, creature.Mesh.Positions.ToArray());
        float folded = Breadth(creature, SkinOf(creature, animator));
        Assert.True(folded < most * rest, $"{seed}: {folded} m to the side, {rest} m spread");
        foreach (int joint in JointsOf(creature))
        {
            Joint of = creature.Skeleton.Joints[joint];
            Quaternion turn = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(of.LocalRotation), animator.LocalPose.Rotations[joint]));
            Assert.True(SwingTwistLimit.Excess(turn, of.Limit) < 1e-3f, $"{seed} {of.Name}");
        }
    }

    private static void ShowsItsWings(ulong seed, float least)
    {
        (Creature creature, CreatureAnimator animator) = Standing(seed);
        float folded = Breadth(creature, SkinOf(creature, animator));
        animator.Emotion = new Emotion(1f, -1f, 1f);
        Walkers.Run(animator, 6f, 30f, default, FlatGround.Level);
        float shown = Breadth(creature, SkinOf(creature, animator));
        animator.Emotion = default;
        Walkers.Run(animator, 12f, 30f, default, FlatGround.Level);
        float again = Breadth(creature, SkinOf(creature, animator));
        Assert.True(shown > least * folded, $"{seed}: {folded} m to the side folded, {shown} m shown");
        Assert.True(Math.Abs(again - folded) < 0.05f * folded, $"{seed}: {folded} m to the side folded, {again} m afterwards");
    }

    private static float HandOverChest(Creature creature, CreatureAnimator animator)
    {
        int hand = creature.Limbs.First(limb => limb.Kind == LimbKind.Wing).Joints[^1];
        return animator.ModelPose.Positions[hand].Y - animator.ModelPose.Positions[creature.Skeleton.FirstOf(JointRole.Chest)].Y;
    }

    private static (Creature Creature, CreatureAnimator Animator) Standing(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, walking);
        var animator = new CreatureAnimator(creature);
        animator.Settings = animator.Settings with { Idle = 0f };
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        return (creature, animator);
    }

    /// <summary>How far above level the upper arm points, seen from the chest, radians.</summary>
    private static float Elevation(Creature creature, CreatureAnimator animator, int shoulder)
    {
        LimbChain wing = creature.Limbs.First(limb => limb.Joints.Contains(shoulder));
        int elbow = wing.Joints[wing.Joints.ToList().IndexOf(shoulder) + 1];
        Vector3 arm = Rotation.Rotate(animator.LocalPose.Rotations[shoulder], creature.Skeleton.LocalPositions[elbow]);
        Vector3 there = Rotation.Rotate(creature.Skeleton.ModelRotations[creature.Skeleton.Parents[shoulder]], arm);
        return MathF.Asin(there.Y / there.Length());
    }

    private static IEnumerable<LimbChain> LeftWings(Creature creature) => creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing && limb.Side == Side.Left);

    private static IEnumerable<int> JointsOf(Creature creature) => creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing).SelectMany(limb => limb.Joints.Take(limb.Joints.Count - 1));

    private static Vector3[] SkinOf(Creature creature, CreatureAnimator animator)
    {
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        var skin = new Vector3[creature.Mesh.Positions.Length];
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, skin, new Vector3[skin.Length]);
        return skin;
    }

    /// <summary>How far to the side the skin goes that wings alone move.</summary>
    private static float Breadth(Creature creature, Vector3[] skin)
    {
        float most = 0f;
        for (int v = 0; v < skin.Length; v++)
        {
            SkinWeights weights = creature.Mesh.Weights[v];
            if (creature.Skeleton.Joints[weights.Joint0].Role == JointRole.Wing && weights.Weights.X > 0.9f)
            {
                most = Math.Max(most, Math.Abs(skin[v].X));
            }
        }

        return most;
    }
}
