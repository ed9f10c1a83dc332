using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Genetics.Criteria;

/// <summary>A criterion and how much it counts.</summary>
/// <param name="Criterion">What is asked.</param>
/// <param name="Weight">Above 0; twice the weight counts as if it were there twice.</param>
public sealed record WeightedCriterion(ICriterion Criterion, double Weight);

/// <summary>What a population is bred towards: one criterion, or several of which a creature has to do well in all.</summary>
/// <remarks>Scores are multiplied, each to the power of its weight over the sum of all weights, so that units do not matter and nothing makes up for a 0. Based on: P. W. Bridgman, "Dimensional Analysis" (1922), the weighted product.</remarks>
public sealed class Goal
{
    private readonly WeightedCriterion[] parts;
    private readonly double sum;

    /// <summary>One criterion.</summary>
    public Goal(ICriterion criterion)
        : this(new[] { new WeightedCriterion(criterion, 1) })
    {
    }

    /// <summary>Several.</summary>
    /// <exception cref="ArgumentException">There is none, or a weight is not above 0.</exception>
    public Goal(IReadOnlyList<WeightedCriterion> parts)
    {
        this.parts = new List<WeightedCriterion>(parts ?? throw new ArgumentNullException(nameof(parts))).ToArray();
        foreach (WeightedCriterion part in this.parts)
        {
            _ = part?.Criterion ?? throw new ArgumentNullException(nameof(parts), "a criterion is null");
            sum += part.Weight > 0 && part.Weight < double.MaxValue ? part.Weight : throw new ArgumentException(FormattableString.Invariant($"the weight of {part.Criterion.Name} is {part.Weight}; expected a number above 0"), nameof(parts));
        }

        if (this.parts.Length == 0)
        {
            throw new ArgumentException("there is no criterion; expected at least one", nameof(parts));
        }
    }

    /// <summary>Its criteria.</summary>
    public IReadOnlyList<WeightedCriterion> Parts => parts;

    /// <summary>Whether it has a criterion that looks at something.</summary>
    internal bool Asks(CriterionInput input) => Array.Exists(parts, part => part.Criterion.Input == input);

    /// <summary>Asks the criteria that look at one thing, and puts their scores in their places.</summary>
    /// <exception cref="InvalidOperationException">A score is below 0 or not finite.</exception>
    internal ValueList<double> Ask(CriterionInput input, Candidate candidate, ValueList<double> scores)
    {
        for (int i = 0; i < parts.Length; i++)
        {
            ICriterion criterion = parts[i].Criterion;
            if (criterion.Input == input)
            {
                double score = criterion.Score(candidate);
                scores = score >= 0 && score <= double.MaxValue ? scores.With(i, score) : throw new InvalidOperationException(FormattableString.Invariant($"the criterion {criterion.Name} gave {score}; expected 0 or more, finite"));
            }
        }

        return scores;
    }

    /// <summary>What the scores of all criteria come to.</summary>
    internal double Total(ValueList<double> scores) => Total(scores, CriterionInput.Company, CriterionInput.Motion);

    /// <summary>What the scores of those criteria come to that look at one thing, another, or what is between them in cost.</summary>
    internal double Total(ValueList<double> scores, CriterionInput cheapest, CriterionInput dearest)
    {
        double logarithm = 0;
        for (int i = 0; i < parts.Length; i++)
        {
            CriterionInput input = parts[i].Criterion.Input;
            if (input >= cheapest && input <= dearest)
            {
                if (scores[i] == 0)
                {
                    return 0;
                }

                logarithm += parts[i].Weight * PortableMath.Log(scores[i]);
            }
        }

        return PortableMath.Exp(logarithm / sum);
    }
}
