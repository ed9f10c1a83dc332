using System;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Coats;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class CoatContrastTests
{
    private static readonly CoatBlueprint coat = BlueprintSampler.Sample(3).Coat;

    [Fact]
    public void An_animal_keeps_its_coat() => Assert.Same(coat, CoatContrast.On(coat, 0));

    [Theory]
    [InlineData(0.94, 0.93, 0.9)]
    [InlineData(0.17, 0.16, 0.16)]
    [InlineData(0.55, 0.5, 0.57)]
    public void A_mixed_body_is_neither_blank_nor_a_hole(double lightness, double back, double pattern)
    {
        CoatBlueprint drawn = coat with { Base = With(coat.Base, lightness), Back = With(coat.Back, back), Limb = With(coat.Limb, back), Pattern = With(coat.Pattern, pattern) };
        CoatBlueprint worn = CoatContrast.On(drawn, 1);
        Assert.InRange(worn.Base.Lightness, 0.359, 0.801);
        Assert.InRange(worn.Back.Lightness, 0.249, 0.9);
        Assert.InRange(worn.Limb.Lightness, 0.249, 0.9);
        Assert.InRange(Math.Abs(worn.Pattern.Lightness - worn.Base.Lightness), 0.159, 1);
        Assert.True(worn.Base.Lightness < 0.79 || worn.Base.Lightness - worn.Back.Lightness > 0.2, "the back of a pale coat is as pale");
        Assert.Equal((drawn.Base.Hue, drawn.Base.Chroma, drawn.PatternKind), (worn.Base.Hue, worn.Base.Chroma, worn.PatternKind));
    }

    [Fact]
    public void A_coat_within_the_bounds_is_worn_as_it_was_drawn()
    {
        CoatBlueprint drawn = coat with { Base = With(coat.Base, 0.6), Back = With(coat.Back, 0.5), Limb = With(coat.Limb, 0.45), Pattern = With(coat.Pattern, 0.4) };
        Assert.Equal(drawn, CoatContrast.On(drawn, 1));
    }

    [Fact]
    public void Strange_creatures_are_white_and_black_only_where_that_is_rare()
    {
        int rare = Enumerable.Range(24910000, 600).Count(seed => BlueprintSampler.Sample((ulong)seed).Coat.Base.Lightness is < 0.359 or > 0.801);
        Assert.InRange(rare, 1, 40);
    }

    private static ColourBlueprint With(ColourBlueprint colour, double lightness) => colour with { Lightness = lightness };
}
