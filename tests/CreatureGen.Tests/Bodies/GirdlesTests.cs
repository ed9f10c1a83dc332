using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class GirdlesTests
{
    private const int Belly = BodyGrid.Segments / 2;

    /// <summary>Least rise of the belly from the brisket to the groin in radii of the section, above what the tables give: in dogs it is half of the trunk's depth.</summary>
    private const double Rise = 0.3;

    [Fact]
    public void Trunks_of_fish_and_snakes_on_legs_under_them_have_withers_a_dip_a_croup_and_a_belly_that_rises_to_the_groin()
    {
        int logs = 0;
        for (ulong seed = 10420001; seed <= 10420600; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            if (creature.Plan is not (BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar) || Footless(creature.Body.Blend) < 0.6 || creature.Body.Shell.Style != ShellStyle.None)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            BodySkin skin = BodySkin.Span(shape, creature);
            Assert.True(Factor(skin, StationRing.Shoulder + 1, 0) > 1.05 && Factor(skin, 32, 0) < 0.93 && Factor(skin, 40, 0) > 1.08, FormattableString.Invariant($"{seed}: a straight back"));
            Assert.True(Factor(skin, StationRing.Shoulder, Belly) - Factor(skin, StationRing.Loin, Belly) > Rise, FormattableString.Invariant($"{seed}: a straight belly"));
            logs++;
        }

        Assert.True(logs > 3);
    }

    [Fact]
    public void Straight_backs_of_mixed_trunks_over_legs_under_them_are_given_withers_a_dip_and_a_croup()
    {
        foreach (ulong seed in new ulong[] { 10720009, 10720011, 10830012, 11010059, 11010060 })
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            BodySkin skin = BodySkin.Span(shape, creature);
            Assert.True(Factor(skin, 28, 0) - Factor(skin, 33, 0) > 0.08 && Factor(skin, 39, 0) - Factor(skin, 33, 0) > 0.08, FormattableString.Invariant($"{seed}: a straight back"));
        }
    }

    [Fact]
    public void Trunks_between_legs_out_to_their_sides_have_withers_a_dip_and_hips()
    {
        int tubes = 0;
        for (ulong seed = 24902000; seed < 24902120; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            if (creature.Plan != BodyPlan.Sprawling || creature.Legs.Count < 2 || LegKinds.Of(creature.Legs[^1].Archetype).Step.Leaps || creature.Wings.Count > 0 || creature.Body.Shell.Style != ShellStyle.None)
            {
                continue;
            }

            BodySkin skin = BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature);
            int fore = (int)creature.Legs.Min(leg => leg.Socket.Ring + (0.5 * leg.Socket.Rows));
            int hind = (int)creature.Legs.Max(leg => leg.Socket.Ring + (0.5 * leg.Socket.Rows));
            Assert.True(Factor(skin, fore, 0) - Factor(skin, fore + 5, 0) > 0.1 && Factor(skin, hind - 1, 0) - Factor(skin, fore + 5, 0) > 0.1, FormattableString.Invariant($"{seed}: a straight back"));
            tubes++;
        }

        Assert.True(tubes > 8, $"{tubes} tubes");
    }

    [Fact]
    public void Swimmers_keep_the_torsos_of_their_bodies()
    {
        for (ulong seed = 10420001; seed <= 10420060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            int own = creature.Body.Blend.Bodies.Sum(body => SpeciesCatalogue.Find(body.Name).Relief.Length);
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            Assert.True(own == Girdles.Of(creature, shape).Count, FormattableString.Invariant($"{seed}, {creature.Plan} {creature.Body.Blend.First}"));
        }
    }

    [Fact]
    public void Trunks_that_stand_upright_have_a_furrow_between_shoulder_blades_and_a_waist_above_buttocks()
    {
        int upright = 0;
        for (ulong seed = 18000057; upright < 8; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            if (creature.Plan == BodyPlan.Upright && creature.Body.Shell.Style == ShellStyle.None)
            {
                BodySkin skin = BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature);
                Assert.True(Relief(skin, 27, 3) - Relief(skin, 30, 0) > 0.08, FormattableString.Invariant($"{seed}: a flat back"));
                Assert.True(Relief(skin, 40, 4) - Relief(skin, 35, 7) > 0.12, FormattableString.Invariant($"{seed}: a pipe"));
                upright++;
            }
        }
    }

    /// <summary>What swells of the skin of a ring and a segment, in its section: squared distances from the spine in half axes would be 1 without.</summary>
    private static double Relief(BodySkin skin, int ring, int segment)
    {
        double angle = Math.Tau * segment / BodyGrid.Segments;
        Assert.Equal(2, skin.Shape.TopExponent[ring], 0.9);
        double section = new System.Numerics.Vector2((float)(Math.Sin(angle) * skin.Shape.Width[ring]), (float)(Math.Cos(angle) * skin.Shape.Top[ring])).Length();
        return (skin[ring, segment] - skin.Shape.Centre(ring)).Length() / section;
    }

    /// <summary>Height of the skin in the middle plane, in that of the section that it is spanned over.</summary>
    private static double Factor(BodySkin skin, int ring, int segment) =>
        (skin[ring, segment] - skin.Shape.Centre(ring)).Length() / (segment == 0 ? skin.Shape.Top[ring] : skin.Shape.Bottom[ring]);

    /// <summary>Share of a torso that comes from fish, whales, snakes and insects.</summary>
    private static double Footless(BodyBlend blend) =>
        blend.Bodies.Select((body, k) => SpeciesCatalogue.Find(body.Name) is { Relief.Length: 0, Class: not AnimalClass.Amphibian and not AnimalClass.Bird } ? blend.TorsoFractions[k] : 0).Sum();
}
