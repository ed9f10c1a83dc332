using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Genetics.Populations;

namespace CreatureGen.Lab.Runtime;

/// <summary>A population that is bred on towards a goal, a generation at a time.</summary>
internal sealed class Evolving
{
    private readonly Goal goal;
    private readonly EvolutionSettings settings;
    private Generation generation;

    /// <param name="founders">Whom it begins with.</param>
    /// <param name="towards">Names of criteria, separated by commas.</param>
    /// <param name="population">How many live at a time.</param>
    /// <param name="mutation">0..1.</param>
    /// <param name="seed">Of all chance.</param>
    public Evolving(IReadOnlyList<CreatureBlueprint> founders, string towards, int population, double mutation, ulong seed)
    {
        goal = new Goal([.. towards.Split(',').Select(name => new WeightedCriterion(CriterionCatalogue.Find(name) ?? throw new ArgumentException("\u201c" + name + "\u201d is no goal"), 1))]);
        settings = EvolutionSettings.Default with { Population = population, Seed = seed, Selection = new TournamentSelection(3, 2), Breeding = new BreedingSettings { Mutation = mutation } };
        generation = Evolution.Found(founders, goal, settings, EvolutionWork.Default);
    }

    /// <summary>The best of all who live.</summary>
    public CreatureBlueprint Best => generation.Best.Blueprint;

    public void Next() => generation = Evolution.Next(generation, goal, settings, EvolutionWork.Default);

    /// <summary>Where it stands, as JSON.</summary>
    public string State() => string.Create(CultureInfo.InvariantCulture, $"{{\"number\":{generation.Number},\"best\":{generation.Best.Score:0.####},\"median\":{generation.Median:0.####}}}");
}
