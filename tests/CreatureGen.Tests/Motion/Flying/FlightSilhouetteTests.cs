using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Flying;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>What fliers look like at cruise.</summary>
public sealed class FlightSilhouetteTests
{
    /// <summary>Least part of a thigh by which its knee is behind its hip: thighs lean ahead as they stand, and swept back by no more than that they were bulbs that hung under the body.</summary>
    private const float LeastSwept = 0.2f;

    /// <summary>Least elevation of a thin wing at the top of its beat, radians: below it, the near blade lies in the line of sight of who looks from ahead and beside.</summary>
    private const double LeastRaised = 0.9;

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

    /// <summary>Some animals of a plan as they cruise, each at so many moments of a beat.</summary>
    private static IEnumerable<StrokeSubject> Cruising(BodyPlan plan, int count, int moments)
    {
        foreach (Creature creature in StrokeSubject.Of(plan, count))
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
