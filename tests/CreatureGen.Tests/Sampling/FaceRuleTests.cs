using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Features;
using CreatureGen.Sampling.Parents;
using CreatureGen.Seeding;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FaceRuleTests
{
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

    private static FeatureBlueprint[] Cleared(string head, string ornaments) => Cleared(head, ornaments, noseHorn, tusk, crownHorn);

    private static FeatureBlueprint[] Cleared(string head, string ornaments, params FeatureBlueprint[] worn)
    {
        SpeciesProfile first = SpeciesCatalogue.Find("bear");
        var parents = new Parentage(first, SpeciesCatalogue.Find(head), SpeciesCatalogue.Find(ornaments)) { Head = SpeciesCatalogue.Find(head), Ornaments = SpeciesCatalogue.Find(ornaments) };
        var builder = new CreatureBuilder(new Seed(1), LocomotionKind.Walking, parents, BodyPlan.Plantigrade, 0.6);
        builder.Features.AddRange(worn);
        FaceRule.Clear(builder);
        return builder.Features.ToArray();
    }

    private static FeatureBlueprint Part(FeatureKind kind, double ring, double length) => new(kind, ring, 0, length, 0.05, 0.5, 0.5, 0.5, 0, 0, 0, 0, 1, 1);
}
