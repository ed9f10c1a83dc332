using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion.Kept;
using Xunit;
using static CreatureGen.Tests.Motion.Falling.GettingUpTests;

namespace CreatureGen.Tests.Motion.Falling;

/// <summary>How creatures go limp, and how they lie.</summary>
public sealed class LimpTests
{
    private const float Frame = 1f / 60f;

    /// <summary>Gaze and springs turn neck and tail after the walk has posed them: taken for velocities, what they turn threw these over their heads, up to 6.8 legs far and 8 % of their extent into the ground.</summary>
    [Theory]
    [InlineData(9991003UL)]
    [InlineData(9990007UL, Explicit = true)]
    [InlineData(9990018UL, Explicit = true)]
    [InlineData(9990005UL)]
    public void Who_goes_limp_as_it_stands_falls_where_it_stands(ulong seed)
    {
        const float MaxMoved = 0.6f;
        const float MinUp = 0.85f;
        const float MaxSunk = 0.01f;
        Creature creature = KeptCreatures.Of(seed);
        var profile = new MotionProfile(creature);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Go(30);
        Vector3 stood = Middle(animator);
        animator.GoLimp();
        float lowest = Go(150);
        Vector3 moved = Middle(animator) - stood;
        int pelvis = creature.Skeleton.FirstOf(JointRole.Pelvis);
        Quaternion turn = Rotation.Multiply(animator.ModelPose.Rotations[pelvis], Rotation.Inverse(creature.Skeleton.ModelRotations[pelvis]));
        float away = new Vector2(moved.X, moved.Z).Length() / profile.LegLength;
        Assert.True(away < MaxMoved, $"{away} leg lengths away");
        Assert.True(Rotation.Rotate(turn, Vector3.UnitY).Y > MinUp, $"its back points {Rotation.Rotate(turn, Vector3.UnitY)}");
        Assert.True(-lowest < MaxSunk * Extent(creature), $"{-lowest / Extent(creature)} of its extent in the ground");

        float Go(int frames)
        {
            float low = 0f;
            for (int i = 0; i < frames; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
                low = i % 4 == 0 ? MathF.Min(low, Lowest(animator)) : low;
            }

            return low;
        }
    }

    /// <summary>Half of these came to stand on their folded legs; the hyena 10040009 lay as a ball on its neck.</summary>
    [Theory]
    [InlineData(10040009UL)]
    [InlineData(10060021UL)]
    [InlineData(10070005UL, Explicit = true)]
    [InlineData(10070008UL, Explicit = true)]
    [InlineData(10070035UL, Explicit = true)]
    public void Who_goes_limp_on_four_legs_comes_to_lie_on_its_side_with_its_head_ahead(ulong seed)
    {
        const float MaxUp = 0.5f;
        const float MaxMoved = 0.8f;
        const float MinAhead = 0.4f;
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var profile = new MotionProfile(creature);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Go(60);
        Vector3 stood = Middle(animator);
        animator.GoLimp();
        Go(180);
        Vector3 moved = Middle(animator) - stood;
        int pelvis = creature.Skeleton.FirstOf(JointRole.Pelvis);
        Quaternion turn = Rotation.Multiply(animator.ModelPose.Rotations[pelvis], Rotation.Inverse(creature.Skeleton.ModelRotations[pelvis]));
        int head = creature.Skeleton.FirstOf(JointRole.Head);
        int neck = creature.Skeleton.FirstOf(JointRole.Neck);
        Vector3 way = animator.ModelPose.Positions[head] - animator.ModelPose.Positions[neck];
        Vector3 ahead = Vec.Normalize(animator.ModelPose.Positions[neck] - animator.ModelPose.Positions[pelvis], Vector3.UnitZ);
        float away = new Vector2(moved.X, moved.Z).Length() / profile.LegLength;
        Assert.True(MathF.Abs(Rotation.Rotate(turn, Vector3.UnitY).Y) < MaxUp, $"its back points {Rotation.Rotate(turn, Vector3.UnitY)}");
        Assert.True(away < MaxMoved, $"{away} leg lengths away");
        Assert.True(Vec.Dot(way, ahead) > MinAhead * way.Length(), $"its head is {Vec.Dot(way, ahead) / way.Length()} of its neck ahead of it");

        void Go(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
            }
        }
    }

    /// <summary>It rolled on until it was belly up, its legs folded on it, or rose before it had come to lie.</summary>
    [Theory]
    [InlineData(24241010UL)]
    [InlineData(24502007UL)]
    [InlineData(24502004UL, Explicit = true)]
    public void Who_is_knocked_down_on_four_legs_lies_on_its_flank_before_it_rises(ulong seed)
    {
        const float MaxUp = 0.3f;
        const float LeastTime = 6f;
        const float MinLegs = 0.45f;
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        var profile = new MotionProfile(creature);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Walkers.Run(animator, 1f, 60f, default, FlatGround.Level);
        float unit = MathF.Sqrt(9.81f * profile.LegLength);
        animator.Hit(creature.Skeleton.FirstOf(JointRole.Head), new Vector3(-0.8f * unit * creature.Mass.Mass, 0f, 0f));
        int frames = 0;
        do
        {
            animator.Update(Frame, default, FlatGround.Level);
            frames++;
        }
        while (animator.State == BodyState.Limp);

        int pelvis = creature.Skeleton.FirstOf(JointRole.Pelvis);
        Quaternion turn = Rotation.Multiply(animator.ModelPose.Rotations[pelvis], Rotation.Inverse(creature.Skeleton.ModelRotations[pelvis]));
        float legs = profile.Legs!.Legs.Average(leg => Vec.Distance(animator.ModelPose.Positions[leg.Hip], animator.ModelPose.Positions[leg.Ankle]) / leg.Length);
        Assert.InRange(Rotation.Rotate(turn, Vector3.UnitY).Y, -MaxUp, MaxUp);
        Assert.InRange(frames * Frame, LeastTime * MathF.Sqrt(profile.LegLength / 9.81f), 20f);
        Assert.InRange(legs, MinLegs, 1f);
    }

    /// <summary>The speed at which it had walked was shown until it stood again.</summary>
    [Fact]
    public void Who_lies_and_gets_up_goes_at_no_speed()
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(42, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        for (int i = 0; i < 120; i++)
        {
            animator.Update(Frame, new MotionInput(0.5f), FlatGround.Level);
        }

        Assert.InRange(animator.Speed, 0.3f, 0.6f);
        animator.GoLimp();
        animator.GetUp();
        int lay = 0;
        for (int i = 0; i < 900 && (i == 0 || animator.State != BodyState.Supported); i++)
        {
            animator.Update(Frame, new MotionInput(0.5f), FlatGround.Level);
            Assert.True(animator.State is not (BodyState.Limp or BodyState.Rising) || animator.Speed == 0f, $"{animator.State} at {animator.Speed} m/s");
            lay += animator.State == BodyState.Rising ? 1 : 0;
        }

        Assert.InRange(lay, 10, 800);
    }

    /// <summary>It was put under the body at once, up to 0.2 m away and turned round, and what followed it, a camera, jumped.</summary>
    [Theory]
    [InlineData(10600001UL)]
    [InlineData(10600002UL)]
    [InlineData(10600007UL, Explicit = true)]
    [InlineData(10600012UL, Explicit = true)]
    [InlineData(10600018UL)]
    [InlineData(10600020UL, Explicit = true)]
    public void The_root_of_who_falls_and_gets_up_does_not_jump(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        var animator = new CreatureAnimator(profile);
        float unit = MathF.Sqrt(9.81f * profile.LegLength);
        RootPlace before = animator.Root;
        Vector3 velocity = Vector3.Zero;
        int up = 0;
        for (int i = 0; i < 1500 && up < 60; i++)
        {
            animator.Update(Frame, new MotionInput(0.3f * unit), FlatGround.Level);
            if (i == 90)
            {
                animator.GoLimp();
                animator.GetUp();
            }

            Vector3 now = (animator.Root.Position - before.Position) / Frame;
            float turn = (float)Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before.Rotation), animator.Root.Rotation)) / Frame;
            Assert.True((now - velocity).Length() < 0.8f * unit, $"from {velocity} to {now} m/s in an update, {animator.State} at {i * Frame} s");
            Assert.True(turn < 3f / profile.LegLength * unit, $"{turn} rad/s, {animator.State} at {i * Frame} s");
            (before, velocity) = (animator.Root, now);
            up += i > 90 && animator.State == BodyState.Supported ? 1 : 0;
        }

        Assert.Equal(60, up);
    }

    /// <summary>The root of a fish that lay on the ground was below it, and came up at once as it swam again.</summary>
    [Theory]
    [InlineData(10600001UL)]
    [InlineData(10600002UL)]
    [InlineData(10600004UL, Explicit = true)]
    public void The_root_of_a_swimmer_that_lay_on_the_ground_comes_up_with_its_body(ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
        var animator = new CreatureAnimator(creature);
        float size = Extent(creature);
        Vector3 before = animator.Root.Position;
        animator.GoLimp();
        int up = 0;
        for (int i = 0; i < 1800 && up < 60; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            if (i == 600)
            {
                animator.GetUp();
            }

            Assert.True((animator.Root.Position - before).Length() < 0.02f * size, $"{(animator.Root.Position - before).Length() / size} of its size in an update, {animator.State} at {i * Frame} s");
            before = animator.Root.Position;
            up += i > 600 && animator.State == BodyState.Supported ? 1 : 0;
        }

        Assert.Equal(60, up);
    }

    /// <summary>They were thrown open, at 70 rad/s, and sank again.</summary>
    [Fact]
    public void Lids_of_a_sleeper_that_goes_limp_stay_shut()
    {
        var animator = new CreatureAnimator(CreatureGenerator.Generate(10600007, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        int lid = animator.Profile.Subject.Skeleton.IndexOf("UpperLid_L");
        animator.Perform("Sleep");
        for (int i = 0; i < 480; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
        }

        Quaternion asleep = animator.LocalPose.Rotations[lid];
        animator.GoLimp();
        for (int i = 0; i < 60; i++)
        {
            animator.Update(Frame, default, FlatGround.Level);
            double moved = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(asleep), animator.LocalPose.Rotations[lid]));
            Assert.True(moved < 0.35, $"{moved} rad, {i} updates after it went limp");
        }
    }

    /// <summary>An act moves the whole of a body in the water or in the air; that was taken for a velocity, and shot a whale away at 50 m/s.</summary>
    [Theory]
    [InlineData(RequestedKind.Swimming, 10620040UL, "Sniff")]
    [InlineData(RequestedKind.Swimming, 10620033UL, "Eat")]
    [InlineData(RequestedKind.Flying, 10610007UL, "Bite")]
    public void Who_goes_limp_in_an_act_in_the_water_or_in_the_air_is_not_thrown(RequestedKind kind, ulong seed, string act)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        var profile = new MotionProfile(creature);
        float duration = new CreatureAnimator(profile).Acts.Find(act).Seconds;
        for (int part = 1; part < 8; part++)
        {
            var animator = new CreatureAnimator(profile);
            animator.Teleport(new RootPlace(new Vector3(0f, 50f, 0f), Quaternion.Identity), FlatGround.Level);
            Assert.Equal(ActStatus.Started, animator.Perform(act).Status);
            for (float time = 0f; time < 0.125f * part * duration; time += Frame)
            {
                animator.Update(Frame, default, FlatGround.Level);
            }

            Vector3 before = Middle(animator);
            animator.GoLimp();
            for (int i = 0; i < 6; i++)
            {
                animator.Update(Frame, default, FlatGround.Level);
            }

            float speed = (Middle(animator) - before).Length() / (6 * Frame);
            Assert.True(speed < 2f * MathF.Sqrt(Extent(creature)), $"{speed} m/s after {part} eighths of {act}");
        }
    }

    [Fact]
    public void Nothing_of_head_and_tail_jumps_as_a_creature_that_looks_aside_goes_limp()
    {
        const float FastestJoint = 12f;
        MotionProfile profile = FreeFallTests.Lot(640, 1).Single();
        Skeleton skeleton = profile.Subject.Skeleton;
        var animator = new CreatureAnimator(profile) { LookAt = new Vector3(5f, 1f, 1f) };
        animator.Teleport(RootPlace.Identity, FlatGround.Level);
        Quaternion[] before = [];
        for (int i = 0; i < 64; i++)
        {
            if (i == 60)
            {
                animator.GoLimp();
            }

            animator.Update(Frame, default, FlatGround.Level);
            for (int j = 0; i >= 60 && j < skeleton.Count; j++)
            {
                double speed = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), animator.LocalPose.Rotations[j])) / Frame;
                Assert.True(skeleton.Joints[j].Role is JointRole.Lid or JointRole.Ear || speed < FastestJoint, $"{skeleton.Joints[j].Name} turns by {speed} rad/s in update {i}");
            }

            before = animator.LocalPose.Rotations.ToArray();
        }
    }

    /// <summary>What heads and tails wear, as frills, stands out of what lies on the ground: it would lift the body by .1 to .5 leg lengths in these.</summary>
    [Theory]
    [InlineData(9990007UL)]
    [InlineData(9990018UL, Explicit = true)]
    [InlineData(9741015UL, Explicit = true)]
    public void A_limp_body_does_not_hang_on_what_its_head_wears(ulong seed)
    {
        const float MaxAbove = 0.02f;
        Creature creature = KeptCreatures.Of(seed);
        var profile = new MotionProfile(creature);
        CreatureAnimator animator = Lying(profile);
        float trunk = float.MaxValue;
        float all = float.MaxValue;
        Vector3[] skin = Skin(animator);
        for (int v = 0; v < skin.Length; v++)
        {
            float height = animator.Root.ToWorld(skin[v]).Y;
            all = MathF.Min(all, height);
            trunk = IsOfTrunk(creature.Skeleton, creature.Mesh.Weights[v].Joint0) ? MathF.Min(trunk, height) : trunk;
        }

        Assert.True(trunk < MaxAbove * profile.LegLength, $"{trunk / profile.LegLength} leg lengths above the ground");
        Assert.True(-all < 0.01f * Extent(creature), $"{-all / Extent(creature)} of its extent in the ground");
    }

    /// <summary>Whether a joint is neither of neck and head nor of the tail.</summary>
    private static bool IsOfTrunk(Skeleton skeleton, int joint)
    {
        for (int j = joint; j >= 0; j = skeleton.Parents[j])
        {
            if (skeleton.Joints[j].Role is JointRole.Neck or JointRole.Head or JointRole.Tail)
            {
                return false;
            }
        }

        return true;
    }
}
