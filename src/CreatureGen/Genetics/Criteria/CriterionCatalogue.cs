using System;
using System.Collections.Generic;

namespace CreatureGen.Genetics.Criteria;

/// <summary>The criteria that need nothing but a name.</summary>
public static class CriterionCatalogue
{
    private static readonly ICriterion[] all =
    {
        new SpeedCriterion(), new StabilityCriterion(), new TallnessCriterion(), new EconomyCriterion(), new SmoothnessCriterion(), new DistinctnessCriterion(), new StrangenessCriterion(),
    };

    /// <summary>All of them.</summary>
    public static IReadOnlyList<ICriterion> All => all;

    /// <summary>The one of a name; null if there is none.</summary>
    public static ICriterion? Find(string name) => Array.Find(all, criterion => criterion.Name == name);
}
