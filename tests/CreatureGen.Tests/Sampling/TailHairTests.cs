using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class TailHairTests
{
    [Theory]
    [InlineData("canine", 45.5, 46.5)]
    [InlineData("hyena", 45.5, 46.5)]
    [InlineData("bovine", 50, 51)]
    [InlineData("lion", 50, 51)]
    [InlineData("horse", 45, 45.5)]
    [InlineData("rabbit", 44.5, 45.5)]
    public void Furred_tails_wear_the_hair_of_their_species(string body, double first, double last)
    {
        ManeBlueprint hair = Assert.Single(Draw(body, 1).Manes, IsOfTail);
        Assert.InRange(hair.Ring, first, last);
    }

    [Theory]
    [InlineData("feline")]
    [InlineData("lizard")]
    public void Other_tails_are_bare(string body) => Assert.DoesNotContain(Draw(body, 1).Manes, IsOfTail);

    [Fact]
    public void A_tail_wears_its_hair_on_fur_alone()
    {
        for (ulong seed = 10095201; seed <= 10095260; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            SkinCover cover = CreatureGen.Species.SpeciesCatalogue.Find(creature.Body.Blend.Skin).Cover;
            Assert.True(cover is SkinCover.Fur or SkinCover.Wrinkles || !creature.Manes.Any(IsOfTail), $"{seed}");
        }
    }

    [Fact]
    public void Hair_of_the_tail_alone_is_of_the_coat_and_beside_a_mane_of_the_manes_colour()
    {
        CreatureBlueprint horse = Draw("horse", 1);
        var palette = new CoatPalette(horse.Coat);
        IReadOnlyList<ManeBlueprint> tail = horse.Manes.Where(IsOfTail).ToList();
        Assert.Equal(palette.Limb, HairCoat.ColourOf(palette, tail));
        Assert.Equal(palette.Accent, HairCoat.ColourOf(palette, horse.Manes));
    }

    private static bool IsOfTail(ManeBlueprint mane) => !mane.IsOfBody;

    private static CreatureBlueprint Draw(string body, ulong seed) => BlueprintSampler.Sample(seed, SpeciesSubject.Only(body, RequestedKind.Walking));
}
