using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Flying;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>What fliers look like at cruise.</summary>
public sealed class FlightSilhouetteTests
{
    /// <summary>Least part of a thigh by which its knee is behind its hip: thighs lean ahead as they stand, and swept back by no more than that they were bulbs that hung under the body.</summary>
    private const float LeastSwept = 0.2f;

    /// <summary>Least elevation of a thin wing at the top of its beat, radians: below it, the near blade lies in the line of sight of who looks from ahead and beside.</summary>
    private const double LeastRaised = 0.9;

    /// <summary>Most by which hind wings that are broad stand higher or lower than the fore wings, radians.</summary>
    private const double MostApart = 0.45;

    /// <summary>Least that the first knees of insects fold in flight, radians more than as they stand.</summary>
    private const double LeastFold = 0.7;

    /// <summary>Least part of its reach by which the last foot of an insect is behind its hip.</summary>
    private const float LeastTrailing = 0.7f;

    /// <summary>Least distance of the feet of two pairs along the body relative to that of their hips.</summary>
    private const float LeastFan = 1.2f;

    /// <summary>Least part of a fore leg's forearm by which it goes ahead in flight, and of what comes behind the wrist by which it hangs.</summary>
    private const float LeastAhead = 0.6f;
    private const float LeastHanging = 0.5f;

    [Fact]
    public void Knees_of_birds_are_behind_their_hips_in_flight()
    {
        int thighs = 0;
        foreach (StrokeSubject body in Cruising(BodyPlan.Flapping, 12, 1))
        {
            foreach (LimbChain leg in body.Creature.Limbs.Where(limb => limb.Archetype is LimbArchetype.Bird or LimbArchetype.Theropod))
            {
                Vector3 thigh = body.ModelPositions[leg.Joints[2]] - body.ModelPositions[leg.Joints[1]];
                Assert.True(-thigh.Z > LeastSwept * thigh.Length(), FormattableString.Invariant($"{body.Creature.Blueprint.Seed}: a thigh goes {thigh}"));
                thighs++;
            }
        }

        Assert.True(thighs > 6);
    }

    [Fact]
    public void Thin_wings_are_raised_so_far_that_both_blades_are_seen_from_ahead_and_beside()
    {
        var highest = new Dictionary<ulong, double>();
        foreach (StrokeSubject body in Cruising(BodyPlan.Buzzing, 6, 40))
        {
            LimbChain wing = body.Creature.Limbs.First(limb => limb.Kind == LimbKind.InsectWing);
            Vector3 along = Vector3.Normalize(body.ModelPositions[wing.Joints[1]] - body.ModelPositions[wing.Joints[0]]);
            ulong seed = body.Creature.Blueprint.Seed;
            highest[seed] = Math.Max(highest.GetValueOrDefault(seed), Math.Asin(along.Y));
        }

        Assert.Equal(6, highest.Count);
        Assert.All(highest, wing => Assert.True(wing.Value > LeastRaised, FormattableString.Invariant($"{wing.Key}: {wing.Value} rad")));
    }

    /// <summary>A quarter of a beat behind, hind wings were flipped over where the fore wings stood high, and planks from the side and from behind: by up to .9 rad lower than these.</summary>
    [Fact]
    public void Hind_wings_of_butterflies_and_moths_beat_with_the_fore_wings()
    {
        int seen = 0;
        CreatureOptions flying = CreatureOptions.Default with { Kind = RequestedKind.Flying };
        IEnumerable<Creature> broad = Enumerable.Range(24890000, 60)
            .Select(seed => BlueprintSampler.Sample((ulong)seed, flying))
            .Where(blueprint => blueprint.InsectWings.Any(wing => wing.Style is ThinWingStyle.ButterflyHind or ThinWingStyle.MothHind))
            .Take(6)
            .Select(blueprint => CreatureGenerator.Generate(blueprint.Seed, flying));
        foreach (StrokeSubject body in Cruising(broad, 8))
        {
            double[] raised = [.. body.Creature.Limbs.Where(limb => limb.Kind == LimbKind.InsectWing && limb.Side == Side.Left)
                .Select(wing => Math.Asin(Vector3.Normalize(body.ModelPositions[wing.Joints[1]] - body.ModelPositions[wing.Joints[0]]).Y))];
            Assert.True(raised.Length == 2 && Math.Abs(raised[0] - raised[1]) < MostApart, FormattableString.Invariant($"{body.Creature.Blueprint.Seed}: {raised[0]} and {raised[^1]} rad"));
            seen++;
        }

        Assert.Equal(48, seen);
    }

    /// <summary>
    /// They were bent about the length of the body: knees of legs that do not stand straight out to the side let them do so by .16 radians, and insects stood in the air. Folded all alike, they were
    /// seen as one heap below the belly.
    /// </summary>
    [Fact]
    public void Legs_of_insects_are_a_fan_in_flight_of_which_the_first_fold_and_the_last_trail()
    {
        int pairs = 0;
        foreach (StrokeSubject body in Cruising(BodyPlan.Buzzing, 8, 1))
        {
            ulong seed = body.Creature.Blueprint.Seed;
            Vector3[] now = body.ModelPositions;
            LimbChain[] legs = body.Creature.Limbs.Where(limb => limb.Archetype == LimbArchetype.Insect && limb.Side == Side.Left).OrderByDescending(limb => now[limb.Joints[1]].Z).ToArray();
            double folded = Fold(now, legs[0]) - Fold(body.Creature.Skeleton.ModelPositions, legs[0]);
            Assert.True(folded > LeastFold, FormattableString.Invariant($"{seed}: the first knee folds by {folded} rad"));
            Vector3 trailing = now[legs[^1].Joints[^1]] - now[legs[^1].Joints[1]];
            Assert.True(-trailing.Z > LeastTrailing * trailing.Length(), FormattableString.Invariant($"{seed}: the last leg goes {trailing}"));
            for (int i = 1; i < legs.Length; i++)
            {
                float roots = now[legs[i - 1].Joints[1]].Z - now[legs[i].Joints[1]].Z;
                float tips = now[legs[i - 1].Joints[^1]].Z - now[legs[i].Joints[^1]].Z;
                Assert.True(tips > LeastFan * roots, FormattableString.Invariant($"{seed}: tips of pairs that begin {roots} m apart are {tips} m apart"));
                pairs++;
            }
        }

        Assert.True(pairs > 12);
    }

    /// <summary>All swept back alike, four- and six-footed birds had a row of feet below their belly, and the middle legs of six-footed beasts reached ahead like the first.</summary>
    [Fact]
    public void Feet_of_one_kind_are_further_apart_in_flight_than_their_hips()
    {
        int pairs = 0;
        IEnumerable<Creature> mixed = Enumerable.Range(24901000, 48).Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        foreach (StrokeSubject body in Cruising(mixed, 1))
        {
            Vector3[] now = body.ModelPositions;
            foreach (IGrouping<LimbArchetype?, LimbChain> kind in body.Creature.Limbs.Where(limb => limb.Kind == LimbKind.Leg && limb.Side == Side.Left).GroupBy(limb => limb.Archetype))
            {
                LimbChain[] legs = kind.OrderByDescending(limb => now[limb.Joints[1]].Z).ToArray();
                if (legs.Length > 1)
                {
                    float roots = now[legs[0].Joints[1]].Z - now[legs[^1].Joints[1]].Z;
                    float tips = now[legs[0].Joints[^1]].Z - now[legs[^1].Joints[^1]].Z;
                    Assert.True(tips > LeastFan * roots, FormattableString.Invariant($"{body.Creature.Blueprint.Seed}: feet of legs that begin {roots} m apart are {tips} m apart"));
                    pairs++;
                }
            }
        }

        Assert.True(pairs > 12);
    }

    /// <summary>Drawn in below the chest, with the forearm upright and the paw laid back, they were seen as the letter L from ahead and beside.</summary>
    [Fact]
    public void Fore_legs_of_four_footed_fliers_reach_ahead_with_level_forearms_and_let_their_feet_hang()
    {
        int arms = 0;
        IEnumerable<Creature> mixed = Enumerable.Range(24810300, 24).Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        foreach (StrokeSubject body in Cruising(mixed, 1))
        {
            foreach (LimbChain leg in body.Creature.Limbs.Where(limb => limb.Archetype is LimbArchetype.DigitigradeFore or LimbArchetype.PlantigradeFore or LimbArchetype.UnguligradeFore))
            {
                Vector3 forearm = Vector3.Normalize(body.ModelPositions[leg.Joints[3]] - body.ModelPositions[leg.Joints[2]]);
                Vector3 foot = Vector3.Normalize(body.ModelPositions[leg.Joints[4]] - body.ModelPositions[leg.Joints[3]]);
                Assert.True(forearm.Z > LeastAhead && foot.Y < -LeastHanging, FormattableString.Invariant($"{body.Creature.Blueprint.Seed}: a forearm goes {forearm}, its foot {foot}"));
                arms++;
            }
        }

        Assert.True(arms > 10);
    }

    private static double Fold(ReadOnlySpan<Vector3> positions, LimbChain leg)
    {
        Vector3 thigh = Vector3.Normalize(positions[leg.Joints[2]] - positions[leg.Joints[1]]);
        Vector3 shank = Vector3.Normalize(positions[leg.Joints[3]] - positions[leg.Joints[2]]);
        return Math.Acos(Vector3.Dot(thigh, shank));
    }

    /// <summary>Some animals of a plan as they cruise, each at so many moments of a beat.</summary>
    private static IEnumerable<StrokeSubject> Cruising(BodyPlan plan, int count, int moments) => Cruising(StrokeSubject.Of(plan, count), moments);

    private static IEnumerable<StrokeSubject> Cruising(IEnumerable<Creature> creatures, int moments)
    {
        foreach (Creature creature in creatures)
        {
            FlightProfile profile = FlightProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            var input = new FlightInput(FlightIntent.Air, profile.CruiseSpeed);
            FlightState state = FlightState.InAir(profile);
            for (int i = 0; i < 600; i++)
            {
                FlightMotion.Update(profile, input, ref state, 0.02f, body.Local);
            }

            for (int i = 0; i < moments; i++)
            {
                FlightMotion.Update(profile, input, ref state, (float)(1 / (moments * state.Frequency.Value)), body.Local);
                body.ToModel();
                yield return body;
            }
        }
    }
}
