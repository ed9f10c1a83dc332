using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Genetics;
using CreatureGen.Inspection;
using CreatureGen.Repairs;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Genetics;

public sealed class BreedingTests
{
    private static readonly CreatureBlueprint Walker = Sampled(20, RequestedKind.Walking);
    private static readonly CreatureBlueprint Insect = Sampled(28, RequestedKind.Walking);
    private static readonly CreatureBlueprint Flier = Sampled(5, RequestedKind.Flying);
    private static readonly CreatureBlueprint Swimmer = Sampled(17, RequestedKind.Swimming);

    [Fact]
    public void Parents_and_seed_say_which_child_and_nothing_else_does()
    {
        Offspring child = Breeding.Child(Walker, Insect, 4, BreedingSettings.Default);
        Assert.Equal(BlueprintJson.Write(child.Blueprint), BlueprintJson.Write(Breeding.Child(Walker, Insect, 4, BreedingSettings.Default).Blueprint));
        Assert.NotEqual(child.Blueprint, Breeding.Child(Walker, Insect, 5, BreedingSettings.Default).Blueprint);
        Assert.NotEqual(Groups(Walker, Insect), Groups(Walker, Flier));

        static string Groups(CreatureBlueprint a, CreatureBlueprint b) =>
            string.Concat(Breeding.Litter(a, b, 1, 4, BreedingSettings.Default).Select(o => o.Blueprint.Lineage! with { Generation = 1, First = 0, Second = 0 }));
    }

    [Fact]
    public void Creatures_of_all_kinds_have_sound_children_that_read_back_the_same()
    {
        CreatureBlueprint[] parents = [Walker, Insect, Flier, Swimmer];
        for (int i = 0; i < parents.Length; i++)
        {
            for (int k = 0; k < i; k++)
            {
                Offspring child = Breeding.Child(parents[i], parents[k], 1, BreedingSettings.Default);
                Assert.Empty(CreatureInspection.Inspect(child.Creature));
                Assert.Equal(child.Blueprint, BlueprintJson.Read(BlueprintJson.Write(child.Blueprint)).Blueprint);
                Assert.Contains(child.Blueprint.Plan, new[] { parents[i].Plan, parents[k].Plan });
            }
        }
    }

    [Fact]
    public void Each_group_comes_from_the_parent_that_the_lineage_names()
    {
        CreatureBlueprint Of(ParentName parent) => parent == ParentName.First ? Walker : Swimmer;
        foreach (Offspring child in Breeding.Litter(Walker, Swimmer, 3, 6, new BreedingSettings { Mutation = 0 }))
        {
            LineageBlueprint lineage = child.Blueprint.Lineage!;
            Assert.Equal((1, BlueprintIdentity.Of(Walker), BlueprintIdentity.Of(Swimmer)), (lineage.Generation, lineage.First, lineage.Second));
            Assert.Equal(Of(lineage.Frame).Kind, child.Blueprint.Kind);
            Assert.Equal(Of(lineage.Head).Head.Eyes.Style, child.Blueprint.Head.Eyes.Style);
            Assert.Equal(Of(lineage.Head).Body.Blend.Face, child.Blueprint.Body.Blend.Face);
            Assert.Equal(Of(lineage.Skin).Coat.Base, child.Blueprint.Coat.Base);
        }
    }

    [Fact]
    public void No_child_has_all_of_one_parent_nor_head_and_skin_of_the_one_that_gives_the_frame()
    {
        RandomStream random = new Seed(1).Stream();
        var seen = new HashSet<Inheritance>();
        for (int i = 0; i < 2000; i++)
        {
            Inheritance drawn = Inheritance.Draw(random);
            Assert.False(drawn.Head == drawn.Frame && drawn.Skin == drawn.Frame);
            seen.Add(drawn);
        }

        Assert.Equal(24, seen.Count);
    }

    [Fact]
    public void Shares_of_a_mix_add_up_and_the_greatest_bodies_are_kept()
    {
        for (int i = 0; i < 20; i++)
        {
            BodyBlend blend = Crossover.Cross(Walker, Flier, new Seed((ulong)i)).Body.Blend;
            Assert.InRange(blend.Bodies.Count, 1, 6);
            Assert.Equal(blend.Bodies.Count, blend.Bodies.Select(part => part.Name).Distinct().Count());
            foreach (IReadOnlyList<double> shares in new[] { blend.TorsoFractions, blend.HeadFractions, blend.TailFractions })
            {
                Assert.Equal(1, shares.Sum(), 1e-9);
            }
        }
    }

    [Fact]
    public void A_creature_crossed_with_itself_stays_itself()
    {
        CreatureBlueprint clone = Crossover.Cross(Walker, Walker, new Seed(3));
        Assert.Equal(Walker.Legs.Count, clone.Legs.Count);
        Assert.Equal(Walker.Body.Proportions.Neck, clone.Body.Proportions.Neck, 1e-12);
        Assert.Equal(Walker.Coat.Base, clone.Coat.Base);
        Assert.InRange(SpeciesDistance.Between(Walker, clone), 0, 1e-9);
    }

    [Fact]
    public void Creatures_with_one_pair_of_legs_less_are_nearer_than_those_without_any()
    {
        double Without(int pairs) => SpeciesDistance.Between(Walker, Walker with { Legs = new ValueList<LegBlueprint>(Walker.Legs.Skip(pairs)) });
        Assert.InRange(Without(1), 1e-6, 0.8 * Without(Walker.Legs.Count));
    }

    [Fact]
    public void Mutants_differ_more_the_stronger_the_mutation()
    {
        Assert.Same(Walker, Mutation.Mutate(Walker, 0, new Seed(1)));
        double Mean(double strength) => Enumerable.Range(0, 30).Average(i => SpeciesDistance.Between(Walker, Mutation.Mutate(Walker, strength, new Seed((ulong)i))));
        Assert.True(Mean(0.1) < Mean(0.4) && Mean(0.4) < Mean(1), $"{Mean(0.1)}, {Mean(0.4)}, {Mean(1)}");

        // The upper half of the range is for those who want to be surprised: at full strength angles spread eight times as far as at a fifth.
        double Spread(double strength) => Math.Sqrt(Enumerable.Range(0, 800).Average(i => Math.Pow(Mutation.Mutate(Walker, strength, new Seed((ulong)i)).Body.Posture.Head - Walker.Body.Posture.Head, 2)));
        Assert.InRange(Spread(1) / Spread(0.2), 6.5, 10);
        Assert.Throws<ArgumentOutOfRangeException>(() => Mutation.Mutate(Walker, 1.1, new Seed(1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BreedingSettings { Mutation = double.NaN });
    }

    [Fact]
    public void Distance_is_zero_to_itself_the_same_both_ways_and_small_within_a_litter()
    {
        Assert.Equal(0, SpeciesDistance.Between(Flier, Flier));
        Assert.Equal(SpeciesDistance.Between(Flier, Insect), SpeciesDistance.Between(Insect, Flier));
        CreatureBlueprint child = Breeding.Child(Walker, Walker, 1, BreedingSettings.Default).Blueprint;
        Assert.True(SpeciesDistance.Between(Walker, child) < 0.25);
        Assert.True(SpeciesDistance.Between(Walker, Swimmer) > 0.5);
    }

    [Fact]
    public void A_creature_is_known_by_one_number_whoever_its_parents_were()
    {
        CreatureBlueprint child = Breeding.Child(Walker, Insect, 2, BreedingSettings.Default).Blueprint;
        Assert.Equal(BlueprintIdentity.Of(child), BlueprintIdentity.Of(child with { Lineage = null }));
        Assert.NotEqual(BlueprintIdentity.Of(child), BlueprintIdentity.Of(child with { Scale = 1.01 * child.Scale }));
        Assert.Equal(2, Breeding.Child(child, Walker, 1, BreedingSettings.Default).Blueprint.Lineage!.Generation);
    }

    [Fact]
    public void Invalid_parents_are_refused()
    {
        CreatureBlueprint wrong = Samples.Small with { Scale = -1 };
        Assert.Contains("scale = -1", Assert.Throws<ArgumentException>(() => Breeding.Child(Walker, wrong, 1, BreedingSettings.Default)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => Breeding.Litter(Walker, Insect, 1, 0, BreedingSettings.Default));
    }

    [Theory]
    [InlineData(RequestedKind.Walking, 20UL)]
    [InlineData(RequestedKind.Flying, 5UL, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 17UL, Explicit = true)]
    public void The_young_are_small_with_large_heads_and_eyes_and_grow_up_evenly(RequestedKind kind, ulong seed)
    {
        CreatureBlueprint adult = Sampled(seed, kind);
        Assert.Same(adult, Ageing.At(adult, 1).Blueprint);
        RepairReport baby = Ageing.At(adult, 0), child = Ageing.At(adult, 0.5);
        Assert.True(baby.IsSound && child.IsSound);
        double Head(CreatureBlueprint b) => b.Body.Proportions.Head;
        Assert.True(Head(baby.Blueprint) > Head(child.Blueprint) && Head(child.Blueprint) > Head(adult));
        Assert.True(baby.Blueprint.Scale < child.Blueprint.Scale && child.Blueprint.Scale < adult.Scale);
        Assert.True(baby.Blueprint.Head.Eyes.Radius > adult.Head.Eyes.Radius);
        Assert.Throws<ArgumentOutOfRangeException>(() => Ageing.At(adult, -0.1));
    }

    private static CreatureBlueprint Sampled(ulong seed, RequestedKind kind) => BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, TriangleBudget = 8000 });
}
