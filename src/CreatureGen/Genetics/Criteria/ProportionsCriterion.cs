using System;
using CreatureGen.Maths;

namespace CreatureGen.Genetics.Criteria;

/// <summary>Likeness to the proportions of a creature, 0..1: head, neck, trunk, tail, legs, wings, length, height and width for the size, and pairs of legs. 1 for the same, whatever the size and the colours.</summary>
public sealed class ProportionsCriterion : ICriterion
{
    /// <summary>Part of the size that is added to each length, so that no tail and a stump are near one another.</summary>
    private const double Stump = 0.15;

    /// <summary>What a pair of legs more or less counts, as a factor of e in a length.</summary>
    private const double LegPair = 0.5;

    private readonly BodyMeasures wanted;

    /// <summary>Takes what is wanted.</summary>
    public ProportionsCriterion(BodyMeasures wanted) => this.wanted = wanted ?? throw new ArgumentNullException(nameof(wanted));

    /// <inheritdoc/>
    public string Name => "like";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        double[] a = Ratios(wanted);
        double[] b = Ratios(candidate.Measures);
        double apart = LegPair * Math.Abs(wanted.LegPairs - candidate.Measures.LegPairs);
        for (int i = 0; i < a.Length; i++)
        {
            apart += Math.Abs(PortableMath.Log(a[i] / b[i]));
        }

        return PortableMath.Exp(-apart / (a.Length + 1));
    }

    private static double[] Ratios(BodyMeasures m) => Array.ConvertAll(
        new[] { m.Head, m.Neck, m.Trunk, m.Tail, m.Leg, m.Wing, m.Length, m.Height, m.Width },
        length => (length / m.Size) + Stump);
}
