using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>Creatures that go limp and get up again.</summary>
public sealed class GettingUpTests
{
    private const float Frame = 1f / 60f;

    [Theory]
    [InlineData(RequestedKind.Walking, 600, 5)]
    [InlineData(RequestedKind.Flying, 600, 2)]
    [InlineData(RequestedKind.Swimming, 600, 2)]
    [InlineData(RequestedKind.Walking, 605, 11, Explicit = true)]
    [InlineData(RequestedKind.Flying, 602, 4, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 602, 4, Explicit = true)]
    public void Whoever_goes_limp_lies_and_gets_up_within_its_limits_and_out_of_the_ground(RequestedKind kind, ulong first, int count) => Measure(kind, first, count, 0.03f);

    /// <summary>Sinking of all of them, and of those that get up, as parts of the largest extent of the body.</summary>
    [Fact(Explicit = true)]
    public void Hardly_anybody_of_a_hundred_of_each_kind_sinks_farther()
    {
        Measure(RequestedKind.Walking, 700, 100, 0.04f);
        Measure(RequestedKind.Flying, 700, 100, 0.04f);
        Measure(RequestedKind.Swimming, 700, 100, 0.04f);
    }

    [Fact]
    public void A_limp_creature_lies_still_until_it_is_told_to_get_up_and_then_stands_where_it_lay()
    {
        MotionProfile profile = FreeFallTests.Lot(640, 1).Single();
        var animator = new CreatureAnimator(profile);
        Assert.False(animator.GetUp());
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        animator.GoLimp();
        var kinds = new List<MotionEventKind>();
        Go(600);
        Assert.Equal(BodyState.Limp, animator.State);
        Assert.Equal([MotionEventKind.WentLimp], kinds);
        Vector3 lay = animator.Root.Position;
        Assert.True(animator.GetUp());
        Go(900);
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.Equal([MotionEventKind.WentLimp, MotionEventKind.Rises, MotionEventKind.Rose], kinds);
        Assert.True(Vec.Distance(lay, animator.Root.Position) < 0.1f * profile.LegLength);

        void Go(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                kinds.AddRange(animator.Events.ToArray().Where(e => e.Foot < 0).Select(e => e.Kind));
            }
        }
    }

    /// <summary>Legs that go through the ground on their way would lift the body: by .1 to .5 leg lengths in these.</summary>
    [Theory]
    [InlineData(9988008UL)]
    [InlineData(9987002UL)]
    [InlineData(9990009UL, Explicit = true)]
    [InlineData(9990014UL, Explicit = true)]
    [InlineData(9990020UL, Explicit = true)]
    [InlineData(9741004UL, Explicit = true)]
    [InlineData(9741016UL, Explicit = true)]
    [InlineData(9741038UL, Explicit = true)]
    public void Who_has_legs_out_to_the_side_gathers_them_on_the_ground(ulong seed)
    {
        const float MaxAbove = 0.03f;
        const float MaxSunk = 0.02f;
        const float FastestJoint = 15f;
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var profile = new MotionProfile(creature);
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        var watch = new JointWatch(profile);
        float highest = 0f;
        float lowest = 0f;
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            watch.Record(animator.LocalPose.Rotations, Frame);
            highest = MathF.Max(highest, Trunk(animator));
            lowest = i % 4 == 0 ? MathF.Min(lowest, Lowest(animator)) : lowest;
        }

        float above = (highest - Trunk(animator)) / profile.LegLength;
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.True(above < MaxAbove, $"{above} leg lengths above where it stands");
        Assert.True(-lowest < MaxSunk * Extent(creature), $"{-lowest / Extent(creature)} of its extent in the ground");
        Assert.True(Scalar.Degrees(watch.Excess) < 1, $"{Scalar.Degrees(watch.Excess)}° beyond {creature.Skeleton.Joints[Math.Max(watch.ExcessJoint, 0)].Name}");
        Assert.True(watch.Speed < FastestJoint, $"{watch.Speed} rad/s");
    }

    /// <summary>Legs that are turned straight to their places lift the body, by up to 1.2 of its standing height in these, and hang in the air.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 9995009UL)]
    [InlineData(RequestedKind.Walking, 9990001UL, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9990006UL, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9990011UL)]
    [InlineData(RequestedKind.Walking, 9990012UL, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9990013UL, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9990017UL, Explicit = true)]
    [InlineData(RequestedKind.Walking, 9990022UL, Explicit = true)]
    [InlineData(RequestedKind.Flying, 9990004UL)]
    public void Who_has_legs_under_the_body_draws_them_in_before_it_rises(RequestedKind kind, ulong seed)
    {
        const float MaxAbove = 0.05f;
        const float MaxGathered = 0.9f;
        const float MaxSunk = 0.01f;
        const float FastestJoint = 15f;
        const float FastestTrunk = 0.5f;
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        var profile = new MotionProfile(creature);
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        var watch = new JointWatch(profile);
        var heights = new List<float>();
        float lowest = 0f;
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            watch.Record(animator.LocalPose.Rotations, Frame);
            heights.Add(Trunk(animator));
            lowest = i % 4 == 0 ? MathF.Min(lowest, Lowest(animator)) : lowest;
        }

        float stands = Trunk(animator);
        float gathered = heights.Take(heights.Count / 2).Max() / stands;
        float speed = heights.Zip(heights.Skip(1), (a, b) => MathF.Abs(b - a)).Max() / Frame / MathF.Sqrt(9.81f * profile.LegLength);
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.True(heights.Max() - stands < MaxAbove * profile.LegLength, $"{(heights.Max() - stands) / profile.LegLength} leg lengths above where it stands");
        Assert.True(gathered < MaxGathered, $"{gathered} of its standing height in the first half");
        Assert.True(speed < FastestTrunk, $"its trunk goes up or down at {speed} √(gℓ)");
        Assert.True(-lowest < MaxSunk * Extent(creature), $"{-lowest / Extent(creature)} of its extent in the ground");
        Assert.True(Scalar.Degrees(watch.Excess) < 1, $"{Scalar.Degrees(watch.Excess)}° beyond {creature.Skeleton.Joints[Math.Max(watch.ExcessJoint, 0)].Name}");
        Assert.True(watch.Speed < FastestJoint, $"{watch.Speed} rad/s");
    }

    /// <summary>A foot that has come to its place while the body rises does not leave it.</summary>
    /// <summary>Feet that flip over between two updates, limbs that are pressed between two points and what ends at once had lifted these by .066, .053 and .078 of a leg from one update to the next, another than from that to the one after it.</summary>
    [Theory]
    [InlineData(9990005UL)]
    [InlineData(9985019UL)]
    [InlineData(9990002UL, Explicit = true)]
    [InlineData(9990019UL, Explicit = true)]
    [InlineData(9990013UL, Explicit = true)]
    public void No_trunk_jolts_as_its_body_gets_up(ulong seed)
    {
        const float MaxJolt = 0.027f;
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        var heights = new List<float>();
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            heights.Add(Trunk(animator));
        }

        float[] steps = heights.Zip(heights.Skip(1), (a, b) => b - a).ToArray();
        float jolt = steps.Zip(steps.Skip(1), (a, b) => MathF.Abs(b - a)).Max() / profile.LegLength;
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.True(jolt < MaxJolt, $"{jolt} leg lengths");
    }

    [Fact]
    public void Feet_are_planted_while_the_body_rises()
    {
        foreach (MotionProfile profile in FreeFallTests.Lot(650, 6))
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            animator.GoLimp();
            animator.GetUp();
            Vector3[] stood = [];
            var path = new List<Vector3[]>();
            for (int i = 0; i < 3000 && (i < 3 || animator.State != BodyState.Supported); i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                if (animator.State == BodyState.Rising)
                {
                    path.Add(Feet(animator));
                }
            }

            stood = Feet(animator);
            for (int foot = 0; foot < stood.Length; foot++)
            {
                int came = path.FindIndex(path.Count * 3 / 5, feet => Vec.Distance(feet[foot], stood[foot]) < 0.03f * profile.LegLength);
                Assert.True(came >= 0, $"{profile.Subject.Seed} {profile.Subject.Plan}: foot {foot} never comes to its place");
                for (int i = came; i < path.Count; i++)
                {
                    float slip = Vec.Distance(path[i][foot], stood[foot]);
                    Assert.True(slip < 0.06f * profile.LegLength, $"{profile.Subject.Seed} {profile.Subject.Plan}: foot {foot} is {slip / profile.LegLength} legs from its place at {i} of {path.Count}");
                }
            }
        }
    }

    [Fact]
    public void The_next_time_allocates_nothing_and_has_the_same_bits()
    {
        MotionProfile profile = FreeFallTests.Lot(662, 1).Single();
        var animator = new CreatureAnimator(profile);
        Quaternion[] first = Fall();
        Assert.Equal(0, MovingPose.Allocated(() => Go(600), 1));
        animator = new CreatureAnimator(profile);
        Assert.Equal(first, Fall());

        Quaternion[] Fall()
        {
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            Go(500);
            Quaternion[] pose = animator.LocalPose.Rotations.ToArray();
            animator.Teleport(RootPlace.Identity, FlatGround.Level);
            return pose;
        }

        void Go(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                if (i == 20)
                {
                    animator.GoLimp();
                    animator.GetUp();
                }

                animator.Update(Frame, new MotionInput(1f), FlatGround.Level);
            }
        }
    }

    /// <summary>A part of the rise in which it stood already had to end first: .75 τ in the mean of 59 walkers, and up to 1.5.</summary>
    [Theory]
    [InlineData(14020001UL)]
    [InlineData(14020015UL)]
    [InlineData(14020005UL)]
    [InlineData(14020036UL)]
    public void Who_is_asked_to_go_goes_as_soon_as_it_stands_and_its_feet_stay(ulong seed)
    {
        const float MaxJolt = 0.02f;
        const float MaxSlip = 0.06f;
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var input = new MotionInput(profile.Gaits!.Speeds[0].Comfortable);
        float alone = SecondsToRise(profile);
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        int frames = 0;
        for (; animator.State != BodyState.Supported && frames < 3000; frames++)
        {
            animator.Update(Frame, input, FlatGround.Level);
        }

        Assert.InRange(frames * Frame, 0.3f * alone, 0.9f * alone);
        var watch = new JointWatch(profile);
        var heights = new List<float>();
        Vector3[] stood = Feet(animator);
        var left = new bool[stood.Length];
        for (int i = 0; i < 60; i++)
        {
            animator.Update(Frame, input, FlatGround.Level);
            watch.Record(animator.LocalPose.Rotations, Frame);
            heights.Add(Trunk(animator));
            Vector3[] feet = Feet(animator);
            for (int foot = 0; foot < feet.Length; foot++)
            {
                // Late in its stance a foot rolls off over its toes.
                left[foot] |= animator.Foot(foot).Phase == FootPhase.Swing || animator.Foot(foot).Progress > 0.75f;
                float slip = Vec.Distance(feet[foot], stood[foot]) / profile.LegLength;
                Assert.True(left[foot] || slip < MaxSlip, $"foot {foot} slips by {slip} leg lengths");
            }
        }

        float[] steps = heights.Zip(heights.Skip(1), (a, b) => b - a).ToArray();
        float jolt = steps.Zip(steps.Skip(1), (a, b) => MathF.Abs(b - a)).Max() / profile.LegLength;
        Assert.True(animator.Speed > 0.5f * input.Speed, $"{animator.Speed} m/s after a second");
        Assert.True(jolt < MaxJolt, $"{jolt} leg lengths");
        Assert.True(Scalar.Degrees(watch.Excess) < 1, $"{Scalar.Degrees(watch.Excess)}°");
    }

    /// <summary>They took 16 to 18, then up to 15.2 with a rest after each phase: a player waits for that.</summary>
    [Theory]
    [InlineData(1UL)]
    [InlineData(9UL)]
    [InlineData(18UL)]
    [InlineData(34UL)]
    public void Heavy_ones_that_fell_stand_in_fewer_than_sixteen_times_the_root_of_leg_length_over_gravity(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.True(profile.Subject.Mass.Mass > 300f);
        Assert.InRange(SecondsToRise(profile) / MathF.Sqrt(profile.LegLength / 9.81f), 5f, 15.5f);
    }

    /// <summary>It took 14, three quarters of which it only lay.</summary>
    [Fact]
    public void Who_lies_on_its_belly_already_stands_sooner()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(11200002, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(SecondsToRise(profile) / MathF.Sqrt(profile.LegLength / 9.81f), 5f, 11f);
    }

    /// <summary>Arms and wings that were turned straight to their places through the ground heaved these up: to .64, .87 and .55 of their standing height in the first half.</summary>
    [Theory]
    [InlineData(18210022UL, 0.55f)]
    [InlineData(18200007UL, 0.82f, Explicit = true)]
    [InlineData(18210043UL, 0.45f, Explicit = true)]
    public void No_arm_or_wing_that_lies_under_a_body_lifts_it(ulong seed, float most)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        var heights = new List<float>();
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            heights.Add(Trunk(animator));
        }

        Assert.Equal(BodyState.Supported, animator.State);
        Assert.InRange(heights.Take(heights.Count / 2).Max() / Trunk(animator), 0f, most);
    }

    /// <summary>They were heaved up as their legs came under them, lay down on these by .22 to .55 of a leg and rose again. As they were then (<see cref="KeptCreatures"/>).</summary>
    [Theory]
    [InlineData(12500231UL)]
    [InlineData(12500055UL, Explicit = true)]
    [InlineData(12500020UL, Explicit = true)]
    public void Who_is_heaved_up_by_its_legs_rises_from_there(ulong seed)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        float highest = 0f;
        float down = 0f;
        for (int i = 0; i < 3000 && animator.State != BodyState.Supported; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            highest = MathF.Max(highest, Trunk(animator));
            down = MathF.Max(down, highest - Trunk(animator));
        }

        Assert.Equal(BodyState.Supported, animator.State);
        Assert.InRange(down / profile.LegLength, 0f, 0.16f);
    }

    /// <summary>It took 10 from where it stood already.</summary>
    [Fact]
    public void Who_hardly_crouches_rises_in_less_time()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(12500001, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        Assert.InRange(SecondsToRise(profile) / MathF.Sqrt(profile.LegLength / 9.81f), 4f, 9f);
    }

    /// <summary>Who has been limp for six seconds.</summary>
    internal static CreatureAnimator Lying(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        animator.GoLimp();
        for (int i = 0; i < 360; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        return animator;
    }

    private static float SecondsToRise(MotionProfile profile)
    {
        CreatureAnimator animator = Lying(profile);
        animator.GetUp();
        int frames = 0;
        while (animator.State != BodyState.Supported && frames < 3000)
        {
            animator.Update(Frame, default, FlatGround.Level);
            frames++;
        }

        return frames * Frame;
    }

    /// <summary>Mean height of the joints of the trunk, metres.</summary>
    private static float Trunk(CreatureAnimator animator) => Middle(animator).Y;

    /// <summary>Mean place of the joints of the trunk.</summary>
    internal static Vector3 Middle(CreatureAnimator animator)
    {
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        Vector3[] trunk = Enumerable.Range(0, skeleton.Count)
            .Where(j => skeleton.Joints[j].Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest)
            .Select(j => animator.Root.ToWorld(animator.ModelPose.Positions[j])).ToArray();
        return trunk.Aggregate(Vector3.Zero, (sum, place) => sum + place) / trunk.Length;
    }

    private static Vector3[] Feet(CreatureAnimator animator)
    {
        var feet = new Vector3[animator.FootCount];
        for (int i = 0; i < feet.Length; i++)
        {
            feet[i] = animator.Root.ToWorld(animator.ModelPose.Positions[animator.Foot(i).Joint]);
        }

        return feet;
    }

    private static void Measure(RequestedKind kind, ulong first, int count, float deepest)
    {
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
            var profile = new MotionProfile(creature);
            float height = profile.Fall.Value.Height;
            string name = $"{seed} {creature.Blueprint.Plan}";
            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(new Vector3(0f, kind == RequestedKind.Walking ? 0f : 0.5f * height, 0f), Quaternion.Identity), FlatGround.Level);
            var watch = new JointWatch(profile);
            float sunk = 0f;
            int i = 0;
            for (; i < 6000 && (i <= 30 || animator.State != BodyState.Supported); i++)
            {
                if (i == 30)
                {
                    animator.GoLimp();
                    animator.GetUp();
                }

                animator.Update(Frame, new MotionInput(0.7f * MathF.Sqrt(9.81f * height)), FlatGround.Level);
                if (i > 30)
                {
                    watch.Record(animator.LocalPose.Rotations, Frame);
                    sunk = i % 4 == 0 ? MathF.Min(sunk, Lowest(animator)) : sunk;
                }
            }

            Assert.True(animator.State == BodyState.Supported, $"{name}: {animator.State} after {i * Frame} s");
            Assert.True(Scalar.Degrees(watch.Excess) < 1, $"{name}: {Scalar.Degrees(watch.Excess)}° beyond {creature.Skeleton.Joints[Math.Max(watch.ExcessJoint, 0)].Name}");
            Assert.True(kind == RequestedKind.Swimming || -sunk < deepest * Extent(creature), $"{name}: {-sunk / Extent(creature)} of its extent in the ground");
        }
    }

    internal static float Extent(Creature creature)
    {
        Vector3 min = new(float.MaxValue);
        Vector3 max = new(float.MinValue);
        foreach (Vector3 p in creature.Mesh.Positions)
        {
            min = Vector3.Min(min, p);
            max = Vector3.Max(max, p);
        }

        return MathF.Max(max.X - min.X, MathF.Max(max.Y - min.Y, max.Z - min.Z));
    }

    /// <summary>Height of the lowest vertex, metres.</summary>
    internal static float Lowest(CreatureAnimator animator) => Skin(animator).Min(p => animator.Root.ToWorld(p).Y);

    /// <summary>The vertices, model space.</summary>
    internal static Vector3[] Skin(CreatureAnimator animator)
    {
        Creature creature = animator.Profile.Subject.Creature!;
        var matrices = new Matrix4x4[creature.Skeleton.Count];
        SkinMatrices.Fill(creature.Skeleton, animator.ModelPose, matrices);
        var positions = new Vector3[creature.Mesh.Positions.Length];
        var normals = new Vector3[positions.Length];
        CpuSkinning.Skin(matrices, creature.Mesh.Weights, creature.Mesh.Positions, creature.Mesh.Normals, positions, normals);
        return positions;
    }
}
