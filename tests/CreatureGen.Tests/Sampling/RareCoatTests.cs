using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Coats;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class RareCoatTests
{
    private const int Draws = 16000;

    private static readonly CoatBlueprint coat = BlueprintSampler.Sample(3).Coat;

    public static TheoryData<PatternKind> NewKinds => new(PatternKind.Rosettes, PatternKind.Giraffe, PatternKind.Turing);

    [Theory]
    [InlineData(PaletteMood.Any, true, true)]
    [InlineData(PaletteMood.Natural, false, false)]
    [InlineData(PaletteMood.Vivid, false, false)]
    [InlineData(PaletteMood.Pale, true, false)]
    [InlineData(PaletteMood.Dark, false, true)]
    public void One_coat_in_80_is_albino_and_one_in_80_is_black_where_the_mood_allows_it(PaletteMood mood, bool albinos, bool blacks)
    {
        CoatBlueprint[] rare = Rare(mood).ToArray();
        int white = rare.Count(IsAlbino);
        Assert.InRange(white, albinos ? 150 : 0, albinos ? 250 : 0);
        Assert.InRange(rare.Length - white, blacks ? 150 : 0, blacks ? 250 : 0);
    }

    [Fact]
    public void Eyes_stand_out_from_a_rare_coat_and_both_show_their_pattern_as_a_ghost()
    {
        foreach (CoatBlueprint one in Rare(PaletteMood.Any))
        {
            ColourBlueprint[] skin = { one.Base, one.Back, one.Belly, one.Limb };
            Assert.All(skin, colour => Assert.InRange(Math.Abs(one.Iris.Lightness - colour.Lightness), 0.2, 1));
            Assert.InRange(one.Iris.Chroma, 0.12, 0.18);
            Assert.All(skin, colour => Assert.InRange(colour.Lightness, IsAlbino(one) ? 0.83 : 0.19, IsAlbino(one) ? 0.95 : 0.31));
            Assert.All(skin, colour => Assert.InRange(colour.Chroma, 0, 0.04));
            Assert.Equal(coat.PatternKind, one.PatternKind);
            double contrast = (one.Base.Lightness - one.Pattern.Lightness) * one.PatternStrength;
            Assert.InRange(contrast, IsAlbino(one) ? 0.055 : 0.1, IsAlbino(one) ? 0.09 : 0.15);
        }
    }

    [Fact]
    public void An_albino_has_red_eyes_and_a_pink_nose()
    {
        CoatBlueprint one = Rare(PaletteMood.Pale).First();
        foreach (ColourBlueprint pink in new[] { one.Iris, one.Muzzle })
        {
            System.Numerics.Vector3 rgb = OklchColour.ToLinearRgb(pink);
            Assert.True(rgb.X > 1.5f * rgb.Y && rgb.X > 1.5f * rgb.Z);
        }
    }

    [Fact]
    public void Individuals_of_a_rare_species_stay_rare()
    {
        ulong seed = Enumerable.Range(0, 4000).Select(n => (ulong)n).First(n => IsAlbino(BlueprintSampler.Sample(n).Coat));
        for (ulong individual = 0; individual < 20; individual++)
        {
            CoatBlueprint one = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Individual = individual }).Coat;
            Assert.InRange(one.Base.Lightness, 0.84, 0.95);
            Assert.InRange(one.Base.Chroma, 0, 0.03);
        }
    }

    [Theory]
    [MemberData(nameof(NewKinds))]
    public void Seeds_wear_the_new_patterns_and_their_json_text_keeps_them(PatternKind kind)
    {
        CreatureBlueprint[] wearers = Enumerable.Range(0, 1500).Select(n => BlueprintSampler.Sample((ulong)n, CreatureOptions.Default with { Strangeness = 0 })).Where(b => b.Coat.PatternKind == kind).ToArray();
        Assert.InRange(wearers.Length, 15, 400);
        string text = BlueprintJson.Write(wearers[0]);
        Assert.Contains("\"patternKind\": \"" + kind.ToString().ToLowerInvariant() + "\"", text, StringComparison.Ordinal);
        Assert.Equal(wearers[0], BlueprintJson.Read(text).Blueprint);
    }

    [Fact]
    public void Rosettes_and_plates_are_darker_than_their_coat()
    {
        for (ulong seed = 0; seed < 1500; seed++)
        {
            CoatBlueprint one = BlueprintSampler.Sample(seed).Coat;
            if (one.PatternKind is PatternKind.Rosettes or PatternKind.Giraffe)
            {
                Assert.True(one.Pattern.Lightness < one.Base.Lightness - 0.08);
            }
        }
    }

    private static bool IsAlbino(CoatBlueprint one) => one.Base.Lightness > 0.88 && one.Base.Chroma < 0.023 && one.Iris.Hue < 0.4;

    private static IEnumerable<CoatBlueprint> Rare(PaletteMood mood) =>
        Enumerable.Range(0, Draws).Select(n => RareCoats.Perhaps(coat, mood, new Seed((ulong)n).Stream(), mixed: 1)).Where(one => one != coat);
}
