using System;
using CreatureGen.Blueprints;
using CreatureGen.Inspection.Variety;

namespace CreatureGen.Genetics.Criteria;

/// <summary>How far a creature is from any animal: parts of other animals than that which leads in its torso, and bodies in the mix of its torso. Near 0 for an animal, 1 and more for what has no name.</summary>
public sealed class StrangenessCriterion : ICriterion
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
        return Animal + ChimeraDistance.Of(candidate.Blueprint) + (FurtherBody * (BodiesIn(candidate.Blueprint.Body.Blend) - 1));
    }

    /// <summary>Effective number of bodies in a torso: 1 / Σ share².</summary>
    private static double BodiesIn(BodyBlend blend)
    {
        double squares = 0;
        foreach (double share in blend.TorsoShares)
        {
            squares += share * share;
        }

        return 1 / squares;
    }
}
