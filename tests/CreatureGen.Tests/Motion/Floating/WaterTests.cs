using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Floating;

/// <summary>Walkers and fliers that come to water too deep to stand in.</summary>
public sealed class WaterTests
{
    private const float Frame = 1f / 60f;
    private const float Gravity = 9.80665f;

    [Theory]
    [InlineData(9920002UL)]
    [InlineData(9920004UL, Explicit = true)]
    [InlineData(9920006UL, Explicit = true)]
    [InlineData(9920010UL)]
    [InlineData(9920008UL, Explicit = true)]
    public void A_walker_swims_through_a_lake_and_walks_out_on_the_other_shore(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }));
        float unit = MathF.Sqrt(Gravity * profile.LegLength);
        var script = new CourseScript("swim", [new CourseCommand(60f * unit / Gravity, new MotionInput(0.6f * unit))]);
        var simulation = new CourseSimulation(profile, script, CourseGround.Water, CourseRate.Of(60f));
        CreatureAnimator animator = simulation.Animator;
        var water = (IWaterGround)simulation.Surface.Ground;
        int eye = profile.Subject.Skeleton.FirstOf(JointRole.Eye);
        var joints = new JointWatch(profile);
        var kinds = new List<MotionEventKind>();
        float afloat = 0f;
        float since = 0f;
        foreach (float seconds in simulation.Updates())
        {
            kinds.AddRange(animator.Events.ToArray().Where(e => e.Foot < 0).Select(e => e.Kind));
            joints.Record(animator.LocalPose.Rotations, seconds);
            Assert.True(animator.Root.Position.Y > simulation.Surface.HeightAt(animator.Root.Position, 40f * profile.LegLength) - (0.3f * profile.LegLength), "in the bed");
            since = animator.State == BodyState.Afloat ? since + seconds : 0f;
            if (animator.State == BodyState.Afloat)
            {
                afloat += seconds;
                Assert.Equal(FootPhase.Swing, animator.Foot(0).Phase);
                float under = water.DepthAt(animator.Root.ToWorld(animator.ModelPose.Positions[eye]));
                Assert.True(since < 1.5f || under < 0f, $"eyes {under} m under water");
            }
        }

        Assert.Equal([MotionEventKind.EnteredWater, MotionEventKind.LeftWater], kinds.Take(2));
        Assert.True(afloat > 2f, $"{afloat} s afloat");
        Assert.True(joints.Excess < 0.0017, $"{joints.Excess} rad beyond limits");
    }

    [Fact]
    public void Who_falls_into_deep_water_dives_and_comes_up_to_float()
    {
        MotionProfile profile = new(Walkers.Any(3));
        float leg = profile.LegLength;
        var sea = new WaterGround(new FlatGround(new Vector3(0f, -20f * leg, 0f), Vector3.UnitY), Vector3.Zero, Vector3.UnitY);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, 2f * leg, 0f), Quaternion.Identity), sea);
        var states = new List<BodyState> { animator.State };
        float deepest = 0f;
        for (int i = 0; i < 600; i++)
        {
            animator.Update(Frame, default, sea);
            deepest = Math.Min(deepest, animator.Root.Position.Y);
            if (animator.State != states[^1])
            {
                states.Add(animator.State);
            }
        }

        float draught = profile.Float!.Draught;
        Assert.Equal([BodyState.Supported, BodyState.Falling, BodyState.Afloat], states);
        Assert.True(deepest < -1.1f * draught, "it did not dive");
        Assert.True(Math.Abs(animator.Root.Position.Y + draught) < 0.01f * leg, $"floats {animator.Root.Position.Y} m, expected {-draught}");
    }

    [Fact]
    public void A_flier_comes_down_on_water_folds_its_wings_floats_and_flies_up_again()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(9920002, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        float leg = profile.LegLength;
        var sea = new WaterGround(new FlatGround(new Vector3(0f, -30f * leg, 0f), Vector3.UnitY), Vector3.Zero, Vector3.UnitY);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, -profile.Float!.Draught, 0f), Quaternion.Identity), sea);
        Go(animator, 2f, default, sea);
        Assert.Equal(BodyState.Afloat, animator.State);
        float cruise = profile.Flight!.CruiseSpeed;
        Go(animator, 4f, new MotionInput(cruise, ClimbRate: 0.2f * cruise, Medium: MotionMedium.Air), sea);
        Assert.Equal(BodyState.Supported, animator.State);
        Assert.True(animator.Root.Position.Y > leg, "it did not fly up");
        Go(animator, 20f, new MotionInput(0.3f * cruise, ClimbRate: -0.3f * cruise), sea);
        Assert.Equal(BodyState.Afloat, animator.State);
        Assert.True(Math.Abs(animator.Root.Position.Y + profile.Float.Draught) < 0.1f * leg, $"floats at {animator.Root.Position.Y} m");
    }

    [Fact]
    public void Water_in_which_a_walker_can_stand_slows_it_down_and_does_not_carry_it()
    {
        MotionProfile profile = new(Walkers.Any(3));
        float draught = profile.Float!.Draught;
        float unit = MathF.Sqrt(Gravity * profile.LegLength);
        var dry = new CreatureAnimator(profile);
        var wet = new CreatureAnimator(profile);
        var ford = new WaterGround(FlatGround.Level, new Vector3(0f, 0.95f * draught, 0f), Vector3.UnitY);
        Go(dry, 4f, new MotionInput(2f * unit), FlatGround.Level);
        Go(wet, 4f, new MotionInput(2f * unit), ford);
        Assert.Equal(BodyState.Supported, wet.State);
        Assert.True(wet.Speed < 0.9f * dry.Speed, $"{wet.Speed} m/s in water, {dry.Speed} beside it");
    }

    [Fact]
    public void A_game_that_moves_a_walker_through_water_sees_it_swim_there()
    {
        MotionProfile profile = new(Walkers.Any(3));
        float draught = profile.Float!.Draught;
        var sea = new WaterGround(new FlatGround(new Vector3(0f, -30f * draught, 0f), Vector3.UnitY), Vector3.Zero, Vector3.UnitY);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, -draught, 0f), Quaternion.Identity), sea);
        for (int i = 0; i < 120; i++)
        {
            var place = new RootPlace(new Vector3(0f, -draught, 0.01f * i), Quaternion.Identity);
            animator.Follow(Frame, place, sea);
            Assert.Equal(place, animator.Root);
        }

        Assert.Equal(BodyState.Afloat, animator.State);
        Assert.InRange(animator.Speed, 0.55f, 0.65f);
    }

    /// <summary>Upright bodies hung in the water as they stand, with still arms.</summary>
    [Theory]
    [InlineData(1UL)]
    [InlineData(2UL, Explicit = true)]
    public void An_upright_body_lies_ahead_on_deep_water_its_tail_on_the_surface_and_paddles_with_its_arms(ulong seed)
    {
        MotionProfile profile = new(Walkers.Of(BodyPlan.Upright, seed));
        float leg = profile.LegLength;
        var sea = new WaterGround(new FlatGround(new Vector3(0f, -30f * leg, 0f), Vector3.UnitY), Vector3.Zero, Vector3.UnitY);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(new RootPlace(new Vector3(0f, -profile.Float!.Draught, 0f), Quaternion.Identity), sea);
        var input = new MotionInput(MathF.Sqrt(Gravity * leg));
        Go(animator, 4f, input, sea);
        Assert.Equal(BodyState.Afloat, animator.State);
        int[] trunk = profile.Legs!.Trunk;
        int hand = profile.Legs.Arms[0].Wrist;
        float least = float.MaxValue;
        float most = float.MinValue;
        for (int i = 0; i < 180; i++)
        {
            Go(animator, Frame, input, sea);
            Vector3[] at = animator.ModelPose.Positions.ToArray();
            Vector3 back = at[trunk[^1]] - at[trunk[0]];
            Assert.True(back.Z > back.Y, $"its back points {back}");
            Assert.True(at[profile.Legs.Tail[^1]].Y < at[trunk[^1]].Y + (0.3f * leg), "its tail is in the air");
            least = Math.Min(least, at[hand].Z - at[trunk[^1]].Z);
            most = Math.Max(most, at[hand].Z - at[trunk[^1]].Z);
        }

        Assert.True(most > 0f, $"it does not reach ahead: {most}");
        Assert.True(most - least > 0.15f * leg, $"its hand goes by {most - least}");
    }

    [Fact]
    public void A_depth_that_is_no_number_counts_as_no_water()
    {
        var animator = new CreatureAnimator(Walkers.Any(3));
        Go(animator, 1f, default, new BrokenWater());
        Assert.Equal(BodyState.Supported, animator.State);
    }

    [Fact]
    public void Swimming_allocates_nothing()
    {
        MotionProfile profile = new(Walkers.Any(3));
        var sea = new WaterGround(new FlatGround(new Vector3(0f, -30f, 0f), Vector3.UnitY), Vector3.Zero, Vector3.UnitY);
        var animator = new CreatureAnimator(profile);
        Go(animator, 2f, new MotionInput(1f), sea);
        Assert.Equal(0, MovingPose.Allocated(() => Go(animator, 1f, new MotionInput(1f, 0.5f), sea), 2));
    }

    private static void Go(CreatureAnimator animator, float seconds, in MotionInput input, IGround ground)
    {
        int frames = (int)MathF.Round(seconds / Frame);
        for (int i = 0; i < frames; i++)
        {
            animator.Update(Frame, input, ground);
        }
    }

    private sealed class BrokenWater : IWaterGround
    {
        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit) => FlatGround.Level.Cast(origin, direction, distance, out hit);

        public float DepthAt(Vector3 place) => float.NaN;
    }
}
