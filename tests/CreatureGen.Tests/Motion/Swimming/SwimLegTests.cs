using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;
using static CreatureGen.Tests.Motion.Swimming.SwimRun;

namespace CreatureGen.Tests.Motion.Swimming;

public sealed class SwimLegTests
{
    private const int Hip = 1;
    private const int Frames = 60;

    /// <summary>Farthest that the tip of a leg lies out from its hip as it is grown, in the distance between both (.8 of a straight one).</summary>
    private const double FarthestOut = 0.66;

    /// <summary>Least that the tip of a leg hangs below its hip as it is grown, in the distance between both (.2 of one that is laid back along the flank), and least bend of its elbow, degrees.</summary>
    private const double LeastHung = 0.35;
    private const double LeastBend = 20;

    /// <summary>Most that the sole of a foot that is laid back is level, 1 flat.</summary>
    private const double Flattest = 0.8;

    private static readonly Lazy<Creature[]> legged = new(() =>
        new[] { "newt", "crocodile" }.SelectMany(body => Enumerable.Range(0, Thoroughness.IsExhaustive ? 12 : 2).Select(seed => SpeciesSubject.Of(body, RequestedKind.Swimming, (ulong)seed))).ToArray());

    [Fact]
    public void At_cruise_legs_point_back_all_the_time()
    {
        foreach (Creature creature in legged.Value)
        {
            double worst = 0;
            double mean = 0;
            Beat(creature, 1, 0, body => Each(creature, limb =>
            {
                double angle = FromBack(body, limb);
                worst = Math.Max(worst, angle);
                mean += angle / (Frames * 4);
            }));
            Assert.True(worst < Degrees(58), FormattableString.Invariant($"{Name(creature)}: {worst / Degrees(1)} degrees from straight back at worst"));
            Assert.True(mean < Degrees(36), FormattableString.Invariant($"{Name(creature)}: {mean / Degrees(1)} degrees from straight back in the mean"));
        }
    }

    /// <summary>With level soles they were seen on edge from the side, the front and behind: the leg was a peg.</summary>
    [Fact]
    public void At_cruise_feet_stand_on_edge_halfway_rather_than_lie_flat()
    {
        foreach (Creature creature in legged.Value)
        {
            int[] feet = creature.Limbs.Where(limb => limb.Kind is LimbKind.Leg or LimbKind.Arm && limb.Side == Side.Left).Select(limb => limb.Joints[^2]).ToArray();
            double flat = 0;
            Beat(creature, 1, 0, body =>
            {
                foreach (int foot in feet)
                {
                    Vector3 sole = Rotation.Rotate(Rotation.Inverse(creature.Skeleton.ModelRotations[foot]), SoleOf(creature, foot));
                    flat += Math.Abs(Rotation.Rotate(body.ModelRotations[foot], sole).Y) / (Frames * feet.Length);
                }
            });
            Assert.True(flat < Flattest, FormattableString.Invariant($"{Name(creature)}: {flat:0.00} of a level sole in the mean"));
        }
    }

    [Fact]
    public void As_it_is_grown_a_leg_in_the_water_bends_back_at_its_elbow_and_is_no_rod_out_to_the_side()
    {
        foreach (Creature creature in legged.Value)
        {
            Each(creature, limb =>
            {
                Vector3 hip = creature.Skeleton.ModelPositions[limb.Joints[Hip]];
                Vector3 tip = creature.Skeleton.ModelPositions[limb.Joints[^1]];
                double outward = Math.Abs(tip.X - hip.X) / Vec.Length(tip - hip);
                Assert.True(outward < FarthestOut, FormattableString.Invariant($"{Name(creature)}: {outward:0.00} of its reach is out to the side"));
            });
        }
    }

    [Fact]
    public void As_it_is_grown_a_leg_in_the_water_hangs_below_the_flank_from_a_bent_elbow_and_is_no_peg_on_it()
    {
        foreach (Creature creature in legged.Value)
        {
            Each(creature, limb =>
            {
                Vector3[] at = Array.ConvertAll(limb.Joints.ToArray(), joint => creature.Skeleton.ModelPositions[joint]);
                double hung = (at[Hip].Y - at[^1].Y) / Vec.Length(at[^1] - at[Hip]);
                double bend = Math.Acos(Vec.Dot(Vec.Normalize(at[Hip + 1] - at[Hip]), Vec.Normalize(at[Hip + 2] - at[Hip + 1]))) / Degrees(1);
                Assert.True(hung > LeastHung, FormattableString.Invariant($"{Name(creature)}: {hung:0.00} of its reach is below the hip"));
                Assert.True(bend > LeastBend, FormattableString.Invariant($"{Name(creature)}: the elbow is bent by {bend:0} degrees"));
            });
        }
    }

    [Fact]
    public void The_slower_it_swims_the_farther_its_legs_stand_out()
    {
        foreach (Creature creature in legged.Value)
        {
            double before = 0;
            foreach (float cruises in new[] { 1f, 0.6f, 0.3f, 0f })
            {
                double mean = 0;
                Beat(creature, cruises, 0, body => Each(creature, limb => mean += FromBack(body, limb)));
                Assert.True(mean > before, FormattableString.Invariant($"{Name(creature)} at {cruises} cruises: {mean} after {before}"));
                before = mean;
            }
        }
    }

    [Fact]
    public void Legs_stay_within_their_limits_whatever_is_asked()
    {
        foreach (Creature creature in legged.Value)
        {
            var body = new StrokeSubject(creature);
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var state = default(SwimState);
            for (int i = 0; i < 600; i++)
            {
                SwimInput input = Wild(profile, i / 60.0);
                SwimMotion.Update(profile, input with { Speed = i % 240 < 60 ? -input.Speed : input.Speed }, ref state, 1 / (30 * profile.CruiseFrequency), body.Local);
                body.AssertWithinLimits(FormattableString.Invariant($"{Name(creature)} step {i}"));
                Each(creature, limb => Assert.All(limb.Joints, j =>
                    Assert.True(SwingTwistLimit.Excess(Rotation.Multiply(Rotation.Inverse(creature.Skeleton.LocalRotations[j]), body.Rotations[j]), creature.Skeleton.Joints[j].Limit) < 1e-4f)));
            }
        }
    }

    [Theory]
    [InlineData(0, 0, Explicit = true)]
    [InlineData(0.4, 0)]
    [InlineData(1, 0, Explicit = true)]
    [InlineData(2.4, 0, Explicit = true)]
    [InlineData(-0.5, 0, Explicit = true)]
    [InlineData(1, 0.6)]
    [InlineData(0.4, -0.6, Explicit = true)]
    public void Shanks_and_feet_stay_out_of_the_trunk_and_of_other_legs(double cruises, double bend)
    {
        foreach (Creature creature in legged.Value)
        {
            CapsuleCollider[] trunk = creature.Bones.Where(bone => creature.Limbs.All(limb => !limb.Joints.Contains(bone.Joint)) && creature.Skeleton.Mirrors[bone.Joint] == bone.Joint).ToArray();
            double deepest = double.MinValue;
            Beat(creature, (float)cruises, (float)bend, body => Each(creature, limb =>
            {
                CapsuleCollider[] shank = BonesOf(creature, limb, Hip + 1);
                deepest = Math.Max(deepest, Depth(body, shank, trunk));
                foreach (LimbChain other in creature.Limbs.Where(other => other != limb && other.Kind == LimbKind.Leg))
                {
                    deepest = Math.Max(deepest, Depth(body, shank, BonesOf(creature, other, Hip)));
                }
            }));
            Assert.True(deepest < 0, FormattableString.Invariant($"{Name(creature)} at {cruises} cruises: {deepest} m deep"));
        }
    }

    [Fact]
    public void Braking_spreads_the_legs_and_a_c_start_lays_them_back()
    {
        foreach (Creature creature in legged.Value)
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            SwimState state = Steady(profile, new SwimInput(profile.CruiseSpeed), body);
            double cruising = Spread(body);
            Go(profile, default, ref state, 0.35 / profile.CruiseFrequency, 20, body);
            double braking = Spread(body);
            state = Steady(profile, default, body);
            double still = Spread(body);
            Go(profile, new SwimInput(0f, Escape: EscapeTurn.Left), ref state, 0.18 / profile.CruiseFrequency, 20, body);

            Assert.True(braking > 1.3 * cruising && braking > still, FormattableString.Invariant($"{Name(creature)}: {cruising} cruising, {braking} braking, {still} still"));
            Assert.True(Spread(body) < 0.8 * still, FormattableString.Invariant($"{Name(creature)}: {Spread(body)} in a C-start, {still} still"));
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.3)]
    [InlineData(1)]
    public void Half_a_beat_later_a_legged_swimmer_is_its_own_mirror_image(double cruises)
    {
        foreach (Creature creature in legged.Value)
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new SwimInput((float)cruises * profile.CruiseSpeed);
            SwimState state = Steady(profile, input, body);
            Quaternion[] first = (Quaternion[])body.Rotations.Clone();
            Go(profile, input, ref state, 0.5 / state.BeatFrequency, 20, body);
            double apart = 0;
            Each(creature, limb => apart = Math.Max(apart, limb.Joints.Max(j =>
                Rotation.Angle(Rotation.Multiply(Rotation.Inverse(body.Rotations[j]), Rotation.Mirror(first[creature.Skeleton.Mirrors[j]]))))));

            Assert.True(apart < 2e-3, FormattableString.Invariant($"{Name(creature)}: {apart}"));
        }
    }

    [Fact]
    public void Legs_have_no_jump_of_angular_velocity()
    {
        foreach (Creature creature in legged.Value.Where((_, i) => i % 6 == 0))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            float coarse = Jerk(profile, creature, 480);
            float fine = Jerk(profile, creature, 1920);

            // A C-start takes a fifth of a beat: coarser steps do not show how its velocities change.
            Assert.True(fine < 0.45f * coarse, FormattableString.Invariant($"{Name(creature)}: {coarse} with 480 updates to a beat, {fine} with 1920"));
        }
    }

    [Theory]
    [InlineData(LimbArchetype.PlantigradeFore)]
    [InlineData(LimbArchetype.DigitigradeHind)]
    [InlineData(LimbArchetype.Column)]
    [InlineData(LimbArchetype.Insect)]
    [InlineData(LimbArchetype.FrogHind)]
    [InlineData(LimbArchetype.Arm)]
    public void Legs_of_any_form_go_back_as_far_as_their_joints_let_them(LimbArchetype archetype)
    {
        var blueprint = BlueprintSampler.Sample(0, SpeciesSubject.Only("newt", RequestedKind.Swimming));
        Creature creature = CreatureAssembler.Assemble(blueprint with { Legs = new(blueprint.Legs.Select(leg => leg with { Archetype = archetype })) });
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        Steady(profile, default, body);
        double still = Spread(body);
        Steady(profile, new SwimInput(2 * profile.CruiseSpeed), body);

        body.AssertWithinLimits(archetype.ToString());
        Assert.True(Spread(body) < still, FormattableString.Invariant($"{archetype}: {Spread(body)} at speed, {still} still"));
    }

    /// <summary>Swims on steadily for one beat.</summary>
    /// <param name="creature">The swimmer.</param>
    /// <param name="cruises">Its speed.</param>
    /// <param name="bend">How far it turns while it gets on by its own length, radians.</param>
    /// <param name="look">Called in each frame.</param>
    private static void Beat(Creature creature, float cruises, float bend, Action<StrokeSubject> look)
    {
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        var body = new StrokeSubject(creature);
        float speed = cruises * profile.CruiseSpeed;
        var input = new SwimInput(speed, bend * Math.Abs(speed) / profile.BodyLength);
        SwimState state = Steady(profile, input, body);
        for (int i = 0; i < Frames; i++)
        {
            Go(profile, input, ref state, 1 / ((double)Frames * Math.Abs(state.BeatFrequency)), 1, body);
            body.ToModel();
            look(body);
        }
    }

    private static void Each(Creature creature, Action<LimbChain> look)
    {
        LimbChain[] legs = creature.Limbs.Where(limb => limb.Kind is LimbKind.Leg or LimbKind.Arm).ToArray();
        Assert.Equal(4, legs.Length);
        Array.ForEach(legs, look);
    }

    /// <summary>Sum of the angles between the legs, hip to tip, and straight back.</summary>
    private static double Spread(StrokeSubject body)
    {
        double sum = 0;
        body.ToModel();
        Each(body.Creature, limb => sum += FromBack(body, limb));
        return sum;
    }

    private static double FromBack(StrokeSubject body, LimbChain limb)
    {
        Vector3 way = body.ModelPositions[limb.Joints[^1]] - body.ModelPositions[limb.Joints[Hip]];
        return Math.Acos(-way.Z / Vec.Length(way));
    }

    /// <summary>Across the foot of a creature as it is grown: the way in which its skin is thinnest, by the normals that most of it has.</summary>
    private static Vector3 SoleOf(Creature creature, int foot)
    {
        Vector3 sole = Vector3.UnitY;
        for (int round = 0; round < 20; round++)
        {
            Vector3 sum = Vector3.Zero;
            for (int v = 0; v < creature.Mesh.Positions.Length; v++)
            {
                Vector3 normal = creature.Mesh.Normals[v];
                sum += creature.Mesh.Weights[v].Joint0 == foot ? normal * Vec.Dot(normal, sole) : Vector3.Zero;
            }

            sole = Vec.Normalize(sum);
        }

        return sole;
    }

    private static CapsuleCollider[] BonesOf(Creature creature, LimbChain limb, int first) => creature.Bones.Where(bone => limb.Joints.Skip(first).Contains(bone.Joint)).ToArray();

    private static double Depth(StrokeSubject body, IEnumerable<CapsuleCollider> some, IReadOnlyList<CapsuleCollider> others) => some.Max(a => others.Max(b =>
        a.Radius + b.Radius - Math.Sqrt(SegmentDistance.Squared(At(body, a, a.Start), At(body, a, a.End), At(body, b, b.Start), At(body, b, b.End)))));

    private static Vector3 At(StrokeSubject body, CapsuleCollider capsule, Vector3 point) => body.ModelPositions[capsule.Joint] + Rotation.Rotate(body.ModelRotations[capsule.Joint], point);

    private static double Degrees(double angle) => angle * Math.PI / 180;

    private static string Name(Creature creature) => FormattableString.Invariant($"{creature.Blueprint.Body.Blend.First} {creature.Blueprint.Seed}");
}
