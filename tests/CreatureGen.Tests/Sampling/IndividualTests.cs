using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Individuals;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class IndividualTests
{
    private static readonly RequestedKind[] kinds = { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming };

    public static TheoryData<RequestedKind> Kinds => new(kinds);

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_species_shares_plan_bodies_limbs_ornaments_and_pattern(RequestedKind kind)
    {
        foreach ((CreatureBlueprint type, CreatureBlueprint one) in Pairs(kind, 60, 4))
        {
            Assert.Equal(Shared(type), Shared(one));
            Assert.Equal(type.Legs.Select(leg => (leg.Archetype, leg.Stance, leg.Socket, leg.Toes)), one.Legs.Select(leg => (leg.Archetype, leg.Stance, leg.Socket, leg.Toes)));
            Assert.Equal(type.Wings.Select(wing => (wing.Style, wing.Socket)), one.Wings.Select(wing => (wing.Style, wing.Socket)));
            Assert.Equal(type.Fins.Select(fin => (fin.Place, fin.Style, fin.Socket)), one.Fins.Select(fin => (fin.Place, fin.Style, fin.Socket)));
            Assert.Equal(type.Ears.Select(ear => ear.Socket), one.Ears.Select(ear => ear.Socket));
            Assert.Equal(type.Features.Select(part => (part.Kind, part.Ring, part.Segment)), one.Features.Select(part => (part.Kind, part.Ring, part.Segment)));
            Assert.Empty(BlueprintValidator.Validate(one));
        }

        static object Shared(CreatureBlueprint b) =>
            (b.Seed, b.Kind, b.Plan, b.Body.Blend, b.Body.Shell, b.Tail.Style, b.InsectWings.Count, b.Head.Eyes.Style, (b.Coat.PatternKind, b.Coat.PatternSeed, b.Coat.Horn, b.Coat.Claw));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_species_keeps_to_one_family_of_colours(RequestedKind kind)
    {
        foreach ((CreatureBlueprint type, CreatureBlueprint one) in Pairs(kind, 40, 4))
        {
            foreach ((ColourBlueprint a, ColourBlueprint b) in Colours(type.Coat).Zip(Colours(one.Coat)))
            {
                double turn = Math.Abs(a.Hue - b.Hue);
                Assert.InRange(Math.Min(turn, PortableMath.Tau - turn), 0, Scalar.Radians(10.001));
                Assert.InRange(b.Lightness - a.Lightness, -0.0501, 0.0801);
                Assert.InRange(b.Chroma, 0.65 * a.Chroma, 1.21 * a.Chroma);
            }
        }

        static ColourBlueprint[] Colours(CoatBlueprint coat) => new[] { coat.Base, coat.Back, coat.Belly, coat.Limb, coat.Pattern, coat.Accent, coat.Muzzle };
    }

    [Fact]
    public void Every_individual_is_another_one_and_always_the_same()
    {
        var seen = new HashSet<CreatureBlueprint>();
        var marks = new HashSet<int>();
        for (ulong individual = 0; individual < 60; individual++)
        {
            CreatureBlueprint one = Sample(42, RequestedKind.Any, individual);
            Assert.Equal(one, Sample(42, RequestedKind.Any, individual));
            Assert.True(seen.Add(one));
            marks.Add(one.Coat.Marks);
        }

        Assert.InRange(marks.Count, 59, 60);
        Assert.DoesNotContain(BlueprintSampler.Sample(42), seen);
    }

    [Fact]
    public void Neighbouring_and_far_individuals_are_unrelated()
    {
        ulong[] numbers = { 0, 1, 1UL << 32, (1UL << 32) + 1, ulong.MaxValue };
        Assert.Equal(numbers.Length, numbers.Select(number => Sample(7, RequestedKind.Any, number).Coat.Marks).Distinct().Count());
    }

    [Fact]
    public void Without_an_individual_there_is_the_type_of_the_species()
    {
        Assert.Equal(BlueprintSampler.Sample(5), BlueprintSampler.Sample(5, CreatureOptions.Default with { Individual = null }));
        Assert.Equal(0, BlueprintSampler.Sample(5).Coat.Marks);
    }

    [Fact]
    public void Sizes_differ_by_5_to_45_percent_within_the_limits_that_are_asked_for()
    {
        var factors = new List<double>();
        for (ulong individual = 0; individual < 400; individual++)
        {
            factors.Add(IndividualTraits.Draw(new Seed(3), individual).Size);
        }

        Assert.All(factors, factor => Assert.InRange(factor, 0.55, 1.2));
        Assert.All(factors, factor => Assert.True(Math.Abs(factor - 1) >= 0.05 || factor < 1));
        Assert.InRange(factors.Min(), 0.55, 0.6);
        Assert.InRange(factors.Max(), 1.15, 1.2);
        CreatureOptions options = CreatureOptions.Default with { MinScale = 1.1, MaxScale = 1.15 };
        for (ulong individual = 0; individual < 50; individual++)
        {
            Assert.InRange(BlueprintSampler.Sample(9, options with { Individual = individual }).Scale, 1.1, 1.15);
        }
    }

    [Fact]
    public void The_young_have_large_heads_and_eyes_short_legs_and_small_horns()
    {
        var young = new List<(double Head, double Eye, double Hip, double Horn)>();
        var grown = new List<(double Head, double Eye, double Hip, double Horn)>();
        for (ulong seed = 0; seed < 400; seed++)
        {
            CreatureBlueprint type = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            FeatureBlueprint? horn = type.Features.FirstOrDefault(part => part.Kind is FeatureKind.Horn or FeatureKind.Antler);
            if (type.Plan is not (BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade) || horn is null)
            {
                continue;
            }

            for (ulong individual = 0; individual < 8; individual++)
            {
                CreatureBlueprint one = Sample(seed, RequestedKind.Walking, individual);
                double length = one.Features.First(part => part.Kind == horn.Kind).Length / horn.Length;
                var ratios = (one.Body.Proportions.Head / type.Body.Proportions.Head, one.Head.Eyes.Radius / type.Head.Eyes.Radius, one.Body.Elevation / type.Body.Elevation, length);
                (IndividualTraits.Draw(new Seed(seed), individual).Youth > 0.6 ? young : grown).Add(ratios);
            }
        }

        Assert.InRange(young.Average(r => r.Head), 1.12, 1.35);
        Assert.InRange(young.Average(r => r.Eye), 1.2, 1.7);
        Assert.InRange(young.Average(r => r.Hip), 0.6, 0.95);
        Assert.InRange(young.Average(r => r.Horn), 0.3, 0.8);
        Assert.InRange(grown.Average(r => r.Head), 0.97, 1.08);
        Assert.InRange(grown.Average(r => r.Hip), 0.93, 1.05);
    }

    [Fact]
    public void All_individuals_of_a_species_are_triangulated_alike()
    {
        CreatureOptions options = CreatureOptions.Default with { TriangleBudget = 100000 };
        for (ulong seed = 0; seed < 12; seed++)
        {
            CreatureMesh type = CreatureGenerator.Generate(seed, options).Mesh;
            CreatureMesh one = CreatureGenerator.Generate(seed, options with { Individual = seed + 5 }).Mesh;
            Assert.Equal(type.Triangles.Length, one.Triangles.Length);
            Assert.Equal(type.Positions.Length, one.Positions.Length);
        }
    }

    [Fact]
    public void Every_number_of_64_bits_is_an_individual()
    {
        foreach (ulong individual in new[] { 0UL, 1UL, ulong.MaxValue })
        {
            CreatureOptions options = CreatureOptions.Default with { Individual = individual };
            Assert.Empty(options.Validate());
            string text = OptionsJson.Write(options);
            Assert.Contains("\"individual\": \"" + individual.ToString(System.Globalization.CultureInfo.InvariantCulture) + "\"", text, StringComparison.Ordinal);
            Assert.Equal(options, OptionsJson.Read(text).Options);
        }

        Assert.DoesNotContain("individual", OptionsJson.Write(CreatureOptions.Default), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("7")]
    [InlineData("null")]
    [InlineData("\"-1\"")]
    [InlineData("\"18446744073709551616\"")]
    public void An_individual_in_json_is_a_string_of_digits(string value)
    {
        OptionsReading reading = OptionsJson.Read("{\"individual\": " + value + "}");
        Assert.Null(reading.Options);
        Assert.Equal("individual", Assert.Single(reading.Problems).Path);
    }

    private static CreatureBlueprint Sample(ulong seed, RequestedKind kind, ulong individual) =>
        BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, Individual = individual });

    private static IEnumerable<(CreatureBlueprint Type, CreatureBlueprint One)> Pairs(RequestedKind kind, int species, int individuals)
    {
        for (ulong seed = 0; seed < (ulong)species; seed++)
        {
            CreatureBlueprint type = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            for (ulong individual = 0; individual < (ulong)individuals; individual++)
            {
                yield return (type, Sample(seed, kind, individual));
            }
        }
    }
}
