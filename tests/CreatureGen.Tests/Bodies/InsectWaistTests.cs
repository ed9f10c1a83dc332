using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class InsectWaistTests
{
    /// <summary>What the rings of an abdomen leave of a waist, as a factor.</summary>
    private const double Grooved = 1.12;

    /// <summary>In that of the thinner of thorax and abdomen; without it they had a shallow dip.</summary>
    [Theory]
    [InlineData(24764035, RequestedKind.Flying)]
    [InlineData(24764033, RequestedKind.Flying)]
    [InlineData(24764008, RequestedKind.Flying)]
    [InlineData(24764005, RequestedKind.Walking)]
    public void An_insect_that_is_mixed_with_others_has_the_waist_of_its_kind(ulong seed, RequestedKind kind)
    {
        CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
        double waist = SpeciesCatalogue.Find(creature.Body.Blend.First).Waist;
        double stalk = StalkOf(creature);
        Assert.True(waist < 1 && stalk <= Grooved * waist, FormattableString.Invariant($"{seed}: a stalk of {stalk:0.00}, a {creature.Body.Blend.First} has one of {waist:0.00}"));
    }

    /// <summary>Hollowed towards its stalk it was a bowl for who is behind it.</summary>
    [Theory]
    [InlineData(24815007, RequestedKind.Walking)]
    [InlineData(24815007, RequestedKind.Flying)]
    public void A_thorax_ends_round_before_its_stalk(ulong seed, RequestedKind kind)
    {
        CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
        BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
        double half = SizeOf(shape, (StationRing.Ribs + StationRing.Loin) / 2) / SizeOf(shape, StationRing.Ribs);
        double late = SizeOf(shape, StationRing.Loin - 2) / SizeOf(shape, StationRing.Ribs);
        Assert.True(half > 0.75 && late > 0.55, FormattableString.Invariant($"{seed} is {half:0.00} and {late:0.00} of its thorax before the stalk"));
    }

    /// <summary>Deeper grooves were the facets of a cone.</summary>
    [Theory]
    [InlineData(24816023, RequestedKind.Walking)]
    [InlineData(24832002, RequestedKind.Flying)]
    public void Rings_of_an_abdomen_leave_its_outline_by_less_than_their_depth(ulong seed, RequestedKind kind)
    {
        CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
        AnnuliBlueprint annuli = creature.Body.Annuli;
        BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
        BodyShape plain = BodyShaper.Shape(creature.Plan, creature.Body with { Annuli = annuli with { Depth = 0 } }, creature.Head, creature.Tail);
        double[] leaves = Enumerable.Range(annuli.Ring, 9).Select(ring => ((SizeOf(shape, ring) / SizeOf(plain, ring)) - 1) / annuli.Depth).ToArray();
        Assert.True(leaves.Max() is > 0.2 and < 0.55 && leaves.Min() is < -0.4 and > -0.75, FormattableString.Invariant($"{seed}: {leaves.Min():0.00} to {leaves.Max():0.00} depths"));
    }

    [Fact]
    public void Wing_cases_go_on_over_the_waist()
    {
        CreatureBlueprint beetle = Enumerable.Range(1, 60).Select(seed => BlueprintSampler.Sample((ulong)seed, Sampling.SpeciesSubject.Only("beetle", RequestedKind.Walking)))
            .First(creature => creature.Body.Shell.Style == ShellStyle.Elytra);
        Assert.True(StalkOf(beetle) > 0.9);
    }

    private static double StalkOf(CreatureBlueprint creature)
    {
        BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
        double Largest(int first, int last) => Enumerable.Range(first, last - first + 1).Max(ring => SizeOf(shape, ring));
        return SizeOf(shape, StationRing.Loin) / Math.Min(Largest(StationRing.Shoulder, StationRing.Belly), Largest(StationRing.Pelvis, StationRing.TailTip));
    }

    private static double SizeOf(BodyShape shape, int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
}
