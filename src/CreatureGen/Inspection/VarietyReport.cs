using System.Collections.Generic;

namespace CreatureGen.Inspection;

/// <summary>How different a number of creatures are from one another.</summary>
/// <param name="Count">Number of creatures.</param>
/// <param name="TwinFraction">Share of creatures that have a double among the others: outlines from three sides that agree by <see cref="VarietyStudy.TwinLikeness"/> or more.</param>
/// <param name="EffectiveCombinations">
/// Number of combinations of body, plan and limbs that, all equally frequent, would repeat as often: an estimate of 1/Σp² without bias, N(N−1)/Σn(n−1). Where none repeats, N(N−1)/2.
/// </param>
/// <param name="EffectiveWithHeads">The same with the body that gives the head.</param>
/// <param name="ChimeraFraction">Share of creatures whose parts are so far from one another that nobody would name them after one animal.</param>
/// <param name="Clusters">Number of groups that are left when doubles, and doubles of doubles, are put together.</param>
/// <param name="Nearest">The most alike pairs, at most <see cref="VarietyStudy.NearestPairs"/>, the most alike first.</param>
public sealed record VarietyReport(
    int Count,
    double TwinFraction,
    double EffectiveCombinations,
    double EffectiveWithHeads,
    double ChimeraFraction,
    int Clusters,
    IReadOnlyList<LikePair> Nearest);
