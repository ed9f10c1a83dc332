namespace CreatureGen.Genetics.Criteria;

/// <summary>What a criterion looks at, from cheap to dear. Cheap ones are asked first.</summary>
public enum CriterionInput
{
    /// <summary>The blueprint among those of the others: a score that holds for this company alone, and is asked anew in each generation.</summary>
    Company,

    /// <summary>The blueprint: microseconds.</summary>
    Blueprint,

    /// <summary>The creature as it stands: milliseconds.</summary>
    Creature,

    /// <summary>The creature as it moves: tenths of a second.</summary>
    Motion,
}

/// <summary>What a population is bred towards: a number for each creature, the greater the better.</summary>
/// <remarks>
/// A criterion is asked on any thread, for many creatures at a time, and gives the same creature the same score. Scores are compared by their ratios, so that units do not matter: twice the score is twice as
/// good, and 0 is what must not live on.
/// </remarks>
public interface ICriterion
{
    /// <summary>A word for reports.</summary>
    string Name { get; }

    /// <summary>What it looks at.</summary>
    CriterionInput Input { get; }

    /// <summary>How well a creature does: 0 or more, finite.</summary>
    double Score(Candidate candidate);
}
