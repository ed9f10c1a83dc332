using System;
using CreatureGen.Blueprints;
using CreatureGen.Inspection.Variety;
using CreatureGen.Maths;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Strange"/>
internal sealed class StrangenessCriterion : ICriterion
{
    /// <summary>What an animal scores that is only itself: below all others, but alive.</summary>
    private const double Animal = 0.05;

    /// <summary>What each further body in the torso adds.</summary>
    private const double FurtherBody = 0.2;

    /// <inheritdoc/>
    public string Name => "strange";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Blueprint;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        BodyBlueprint body = candidate.Blueprint.Body;
        return Animal + ChimeraDistance.Of(candidate.Blueprint) + (FurtherBody * (BodiesIn(body.Blend) - 1)) + Distortion(body.Proportions);
    }

    /// <summary>Mean logarithm of the factors by which proportions are more or less than those of the bodies.</summary>
    private static double Distortion(BodyProportions p)
    {
        double[] factors = { p.Head, p.Snout, p.Neck, p.NeckGirth, p.Girth, p.Belly, p.Chest, p.Hump, p.Rump, p.Tail, p.TailGirth, p.Depth, p.Width };
        double sum = 0;
        foreach (double factor in factors)
        {
            sum += Math.Abs(PortableMath.Log(factor));
        }

        return sum / factors.Length;
    }

    /// <summary>Effective number of bodies in a torso: 1 / Σ share².</summary>
    private static double BodiesIn(BodyBlend blend)
    {
        double squares = 0;
        foreach (double fraction in blend.TorsoFractions)
        {
            squares += fraction * fraction;
        }

        return 1 / squares;
    }
}
