using CreatureGen.Blueprints;

namespace CreatureGen.Genetics.Populations;

/// <summary>What became of a creature before its judges.</summary>
public enum Verdict
{
    /// <summary>All criteria were asked.</summary>
    Judged,

    /// <summary>It did worse than half of its brood by the cheap criteria, and the dear ones were not asked.</summary>
    SetAside,

    /// <summary>Something of it does not fit together (<see cref="FreakCheck"/>).</summary>
    Freak,
}

/// <summary>A creature of a population and how it does. The creature itself is not kept: its blueprint builds it again.</summary>
/// <param name="Blueprint">Its blueprint, with its lineage if it was bred.</param>
/// <param name="Identity">The number by which it is known (<see cref="BlueprintIdentity"/>).</param>
/// <param name="Measures">Its lengths.</param>
/// <param name="Verdict">What became of it.</param>
/// <param name="Scores">The score of each criterion of the goal; 0 where it was not asked.</param>
/// <param name="Score">What they come to; 0 unless it was judged.</param>
public sealed record Individual(CreatureBlueprint Blueprint, ulong Identity, BodyMeasures Measures, Verdict Verdict, ValueList<double> Scores, double Score);
