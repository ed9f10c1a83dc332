using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Features;
using CreatureGen.Sampling.Parents;
using CreatureGen.Seeding;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FaceRuleTests
{
    /// <summary>Half of the width and of the height of the head, metres.</summary>
    private const double HalfHead = 0.3;

    private static readonly FeatureBlueprint noseHorn = Part(FeatureKind.Horn, 3, 0.3);
    private static readonly FeatureBlueprint tusk = Part(FeatureKind.Tusk, 4, 0.2);
    private static readonly FeatureBlueprint crownHorn = Part(FeatureKind.Horn, 13, 0.3);

    [Fact]
    public void Nothing_of_another_species_grows_from_a_beak() =>
        Assert.Equal(new[] { crownHorn }, Cleared("parrot", "rhino"));

    [Fact]
    public void Of_what_another_species_wears_before_its_face_the_longest_stays() =>
        Assert.Equal(new[] { noseHorn, crownHorn }, Cleared("canine", "rhino"));

    [Fact]
    public void A_crest_of_another_species_leaves_the_snout() =>
        Assert.Equal(new[] { noseHorn, crownHorn }, Cleared("canine", "pterosaur", Part(FeatureKind.Plate, 5, 0.5), noseHorn, crownHorn));

    [Fact]
    public void What_a_species_wears_on_its_own_head_stays() =>
        Assert.Equal(new[] { noseHorn, tusk, crownHorn }, Cleared("rhino", "rhino"));

    [Fact]
    public void The_horn_of_another_species_is_no_longer_than_two_thirds_of_a_face_is_high()
    {
        FeatureBlueprint horn = Assert.Single(Cleared("canine", "rhino", Part(FeatureKind.Horn, 3, 2)));
        Assert.InRange(horn.Length, 0.3, 0.43);
        Assert.True(horn.Radius < 0.05);
    }

    [Fact]
    public void The_own_horn_of_a_head_on_another_body_is_shorter_than_the_face_is_high() =>
        Assert.InRange(Assert.Single(Cleared("rhino", "rhino", Part(FeatureKind.Horn, 3, 2))).Length, 0.4, 0.49);

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void A_single_eye_does_not_look_out_from_behind_a_horn(RequestedKind kind)
    {
        // This one draws a single eye and has a rhino's head.
        CreatureBlueprint creature = BlueprintSampler.Sample(13600002, CreatureOptions.Default with { Kind = kind });
        Assert.Contains(creature.Features, part => part is { Kind: FeatureKind.Horn, Segment: 0, Ring: < 7 });
        Assert.NotEqual(0, creature.Head.Eyes.Segment);
    }

    [Fact]
    public void A_crest_of_another_species_is_no_longer_than_a_head_is_high_by_a_fifth() =>
        Assert.InRange(Assert.Single(Cleared("canine", "pterosaur", Part(FeatureKind.Plate, 12, 2))).Length, 0.6, 0.72);

    [Fact]
    public void A_crest_on_the_own_snout_of_a_head_on_another_body_lies_back_over_its_crown()
    {
        FeatureBlueprint crest = Assert.Single(Cleared("pterosaur", "pterosaur", Part(FeatureKind.Plate, 5, 0.2)));
        Assert.Equal((12, 0.2), (crest.Ring, crest.Length));
        Assert.True(crest.Forward < -Math.Abs(crest.Upward));
    }

    private static FeatureBlueprint[] Cleared(string head, string ornaments) => Cleared(head, ornaments, noseHorn, tusk, crownHorn);

    private static FeatureBlueprint[] Cleared(string head, string ornaments, params FeatureBlueprint[] worn)
    {
        SpeciesProfile first = SpeciesCatalogue.Find("bear");
        var parents = new Parentage(first, SpeciesCatalogue.Find(head), SpeciesCatalogue.Find(ornaments)) { Head = SpeciesCatalogue.Find(head), Ornaments = SpeciesCatalogue.Find(ornaments) };
        var builder = new CreatureBuilder(new Seed(1), LocomotionKind.Walking, parents, BodyPlan.Plantigrade, 0.6);
        builder.Shape = new BodyShape();
        foreach (double[] half in new[] { builder.Shape.Width, builder.Shape.Top, builder.Shape.Bottom })
        {
            Array.Fill(half, HalfHead);
        }

        builder.Features.AddRange(worn);
        FaceRule.Clear(builder);
        return builder.Features.ToArray();
    }

    private static FeatureBlueprint Part(FeatureKind kind, double ring, double length) => new(kind, ring, 0, length, 0.05, 0.5, 0.5, 0.5, 0, 0, 0, 0, 1, 1);
}
