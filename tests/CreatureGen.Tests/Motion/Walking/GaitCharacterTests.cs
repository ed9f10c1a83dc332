using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>What tells the gaits of animals apart at a glance.</summary>
public sealed class GaitCharacterTests
{
    [Theory]
    [InlineData(5012, "RotaryGallop", 30, 50)]
    [InlineData(5019, "RotaryGallop", 30, 50)]
    [InlineData(5055, "RotaryGallop", 30, 50)]
    [InlineData(5002, "TransverseGallop", 25, 38)]
    [InlineData(5018, "TransverseGallop", 25, 38)]
    [InlineData(5048, "TransverseGallop", 25, 38)]
    [InlineData(5011, "TransverseGallop", 8, 20)]
    [InlineData(5014, "TransverseGallop", 8, 20)]
    [InlineData(5029, "TransverseGallop", 10, 22)]
    public void The_backs_of_carnivores_flex_far_as_they_gallop_and_those_of_hoofed_animals_little(int seed, string gait, float min, float max)
    {
        var cycle = new GaitCycle((ulong)seed, Of(gait));
        Assert.InRange(cycle.Range(cycle.Flexion) * 180f / MathF.PI, min, max);
    }

    [Theory]
    [InlineData(5011)]
    [InlineData(5014)]
    [InlineData(5002)]
    public void Who_pronks_arches_its_back_in_the_air_and_flies_high_above_where_it_crouches(int seed)
    {
        GaitCycle arched = Pronking(GaitLibrary.Pronk);
        GaitCycle flat = Pronking(GaitLibrary.Pronk with { Arch = 0f });
        Assert.InRange(arched.Range(arched.Flexion) * 180f / MathF.PI, 10f, 30f);
        Assert.InRange(flat.Range(flat.Flexion) * 180f / MathF.PI, 0f, 5f);
        int pelvis = arched.Joint(JointRole.Pelvis);
        float legs = arched.Animator.Profile.LegLength;
        Assert.InRange(arched.Range(() => arched.Animator.ModelPose.Positions[pelvis].Y) / legs, 0.25f, 0.9f);

        GaitCycle Pronking(Gait gait)
        {
            Creature creature = Walkers.Any((ulong)seed);
            var usual = new MotionProfile(creature);
            return new GaitCycle(new MotionProfile(creature, new GaitSet([new GaitStep(gait, 0f, 0f)], usual.LegLength, usual.Subject.Mass.Mass)), gait);
        }
    }

    [Theory]
    [InlineData(5000)]
    [InlineData(5002)]
    public void The_back_hardly_flexes_in_a_walk(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Walk);
        Assert.InRange(cycle.Range(cycle.Flexion) * 180f / MathF.PI, 0f, 10f);
    }

    [Theory]
    [InlineData(5049)]
    [InlineData(5090)]
    [InlineData(103)]
    [InlineData(282)]
    public void A_leaping_frog_stretches_its_hind_legs_behind_it_and_draws_them_in_before_they_land(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Leap);
        LimbChain leg = Hind(cycle.Creature);
        float behind = 0f;
        float landing = float.MaxValue;
        int air = 0;
        int all = 0;
        cycle.Watch(() =>
        {
            float reach = Behind(cycle, leg);
            FootReport[] feet = Feet(cycle.Animator);
            all++;
            air += feet.All(foot => foot.Phase == FootPhase.Swing) ? 1 : 0;
            behind = feet.All(foot => foot.Phase == FootPhase.Swing) ? Math.Max(behind, reach) : behind;
            FootReport own = feet.Single(foot => foot.Joint == leg.Joints[4]);
            landing = own.Phase == FootPhase.Swing && own.Progress > 0.9f ? Math.Min(landing, reach) : landing;
        });
        Assert.True(behind > 0.6f, $"{behind} of its length behind");
        Assert.True(landing < -0.2f, $"{landing} of its length behind as it lands");
        Assert.True(air > 0.4f * all, $"{air} of {all} in the air");
    }

    [Theory]
    [InlineData(5049)]
    [InlineData(5090)]
    [InlineData(85)]
    [InlineData(103)]
    [InlineData(282)]
    public void A_leaping_frog_takes_off_with_its_nose_up_and_levels_out_to_the_landing_without_a_dive(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Leap);
        int pelvis = cycle.Joint(JointRole.Pelvis);
        int chest = cycle.Joint(JointRole.Chest);
        float before = float.MaxValue;
        float min = float.MaxValue;
        float range = cycle.Range(() =>
        {
            Vector3 trunk = cycle.Animator.ModelPose.Positions[chest] - cycle.Animator.ModelPose.Positions[pelvis];
            float pitch = MathF.Atan2(trunk.Y, trunk.Z) * 180f / MathF.PI;
            bool flies = Feet(cycle.Animator).All(foot => foot.Phase == FootPhase.Swing);
            before = flies ? Math.Min(pitch, before) : float.MaxValue;
            Assert.False(flies && pitch > before + 2f, $"its nose comes up in the air, from {before} to {pitch} degrees");
            min = Math.Min(min, pitch);
            return pitch;
        });
        Assert.InRange(range, 8f, 18f);
        Assert.True(min > 0f, $"{min} degrees");
    }

    [Theory]
    [InlineData(5010)]
    public void A_hop_is_flight_for_the_most_part_and_high(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Hop);
        LimbChain leg = Hind(cycle.Creature);
        int air = 0;
        int all = 0;
        float behind = 0f;
        float rise = cycle.Range(() =>
        {
            all++;
            air += Feet(cycle.Animator).All(foot => foot.Phase == FootPhase.Swing) ? 1 : 0;
            behind = Math.Max(behind, Behind(cycle, leg));
            return cycle.Animator.ModelPose.Positions[leg.Joints[1]].Y;
        });
        Assert.True(air > 0.65f * all, $"{air} of {all} in the air");
        Assert.True(rise > 0.3f * cycle.Profile.LegLength, $"{rise / cycle.Profile.LegLength} leg lengths");
        Assert.True(behind > 0.3f, $"{behind} of its length behind");
        Assert.InRange(1f / cycle.Animator.Frequency, 0.36f, 0.8f);
    }

    [Theory]
    [InlineData(5010)]
    public void A_hopper_pushes_its_hips_up_and_throws_its_trunk_up_with_it(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Hop);
        int hip = Hind(cycle.Creature).Joints[0];
        int neck = cycle.Creature.Skeleton.AllJoints.ToArray().Select((joint, at) => (joint, at)).First(pair => pair.joint.Role == JointRole.Neck).at;
        FootPhase before = Feet(cycle.Animator)[0].Phase;
        float height = 0f;
        double pushed = 0;
        double landed = 0;
        cycle.Watch(() =>
        {
            FootPhase now = Feet(cycle.Animator)[0].Phase;
            Vector3 at = cycle.Animator.ModelPose.Positions[hip];
            Vector3 trunk = cycle.Animator.ModelPose.Positions[neck] - at;
            double pitch = Math.Atan2(trunk.Y, trunk.Z);
            height = before == FootPhase.Stance && now == FootPhase.Swing ? at.Y : height;
            pushed = before == FootPhase.Stance && now == FootPhase.Swing ? pitch : pushed;
            landed = before == FootPhase.Swing && now == FootPhase.Stance ? pitch : landed;
            before = now;
        });
        Assert.True(height > 1.02f * cycle.Creature.Skeleton.ModelPositions[hip].Y, $"hips at {height}, standing at {cycle.Creature.Skeleton.ModelPositions[hip].Y} m");
        Assert.True(pushed > landed + 0.15, $"trunk at {pushed} rad as it pushes off, {landed} as it lands");
    }

    [Theory]
    [InlineData(5022)]
    [InlineData(109)]
    [InlineData(113)]
    public void A_penguin_takes_short_steps_and_leans_over_the_foot_that_carries_it(int seed)
    {
        var cycle = new GaitCycle((ulong)seed, GaitLibrary.Waddle);
        Assert.True(cycle.Speed / cycle.Animator.Frequency < cycle.Profile.LegLength);
        double together = 0;
        double max = 0;
        float away = 0f;
        LimbChain wing = cycle.Creature.Limbs.First(limb => limb.Kind == LimbKind.Wing && limb.Side == Anatomy.Side.Left);
        cycle.Watch(() =>
        {
            Vector3 up = Vector3.Transform(Vector3.UnitY, cycle.TurnOf(JointRole.Chest));
            float load = Feet(cycle.Animator).Sum(foot => foot.Load * (Side(cycle.Creature, foot.Joint) == Anatomy.Side.Left ? 1f : -1f));
            together += up.X * load;
            max = Math.Max(max, Math.Abs(Math.Asin(up.X)));
            int root = wing.Joints[0];
            Quaternion rest = cycle.Creature.Skeleton.LocalRotations[root];
            away = Math.Max(away, 2f * MathF.Acos(Math.Min(1f, Math.Abs(Quaternion.Dot(rest, cycle.Animator.LocalPose.Rotations[root])))));
        });
        Assert.True(together > 0);
        Assert.InRange(max * 180 / Math.PI, 5, 15);
        Assert.InRange(away, 0.2f, 0.5f);
    }

    [Theory]
    [InlineData("Walk", 760, 1170)]
    [InlineData("Trot", 1110, 1530, Explicit = true)]
    [InlineData("RotaryGallop", 1190, 1700, Explicit = true)]
    public void The_carpus_of_dogs_and_cats_folds_and_unfolds_gently(string gait, float median, float worst)
    {
        var rates = new List<float>();
        foreach ((ulong _, Creature creature) in Walkers.WithPlan(BodyPlan.Digitigrade, 120))
        {
            var profile = new MotionProfile(creature);
            if (profile.Gaits!.Speeds.Any(speed => speed.Gait == Of(gait)))
            {
                var cycle = new GaitCycle(profile, Of(gait));
                rates.Add(cycle.Profile.Legs!.Legs.Where(leg => leg.Row == 1).Max(leg => cycle.Fastest(leg.Ankle)) * 180f / MathF.PI);
            }
        }

        rates.Sort();
        Assert.True(rates.Count > 10, $"{rates.Count}");
        Assert.InRange(rates[rates.Count / 2], 0.5f * median, median);
        Assert.InRange(rates[^1], 0f, worst);
    }

    [Theory]
    [InlineData(50)]
    [InlineData(150, Explicit = true)]
    public void Only_penguins_waddle(int count)
    {
        for (ulong seed = 0; seed < (ulong)count; seed++)
        {
            Creature creature = Walkers.Any(seed);
            bool penguin = creature.Blueprint.Body.Blend.First == "penguin";
            var profile = new MotionProfile(creature);
            Assert.Equal(penguin && profile.Gaits != null, profile.Gaits?.Speeds.Any(speed => speed.Gait == GaitLibrary.Waddle) ?? false);
        }
    }

    private static Gait Of(string name) => (Gait)typeof(GaitLibrary).GetProperty(name)!.GetValue(null)!;

    private static FootReport[] Feet(CreatureAnimator animator) => Enumerable.Range(0, animator.FootCount).Select(animator.Foot).ToArray();

    private static Side Side(Creature creature, int joint) => creature.Skeleton.Joints[joint].Side;

    private static LimbChain Hind(Creature creature) => creature.Limbs.Where(limb => limb.Kind == LimbKind.Leg && limb.Stands && limb.Side == Anatomy.Side.Left).OrderBy(limb => limb.Pair).Last();

    /// <summary>How far the ball of a foot is behind its hip, parts of the leg's bones.</summary>
    private static float Behind(GaitCycle cycle, LimbChain leg)
    {
        ReadOnlySpan<Vector3> rest = cycle.Creature.Skeleton.ModelPositions;
        ReadOnlySpan<Vector3> now = cycle.Animator.ModelPose.Positions;
        float length = 0f;
        for (int i = 1; i < 4; i++)
        {
            length += Vector3.Distance(rest[leg.Joints[i]], rest[leg.Joints[i + 1]]);
        }

        return (now[leg.Joints[1]].Z - now[leg.Joints[4]].Z) / length;
    }
}
