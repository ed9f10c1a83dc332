using System.Collections.Generic;
using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Genetics.Criteria;

/// <summary>The criteria that need nothing but a name.</summary>
public static class CriterionCatalogue
{
    /// <summary>Speed for its size: the top speed v that the creature's motion allows, as v / √(g·size). The root of a Froude number, so that mice and horses compare.</summary>
    /// <remarks>What walks has the top speed of its gaits (<see cref="GaitSet.TopSpeed"/>); what flies, swims or crawls has that of its cruise. Source of the ratio: R. McN. Alexander, A. S. Jayes (1983).</remarks>
    public static ICriterion Fast { get; } = new SpeedCriterion();

    /// <summary>How firmly a creature stands: the tangent of the least slope on which it would tip over. 0 for what does not stand.</summary>
    /// <remarks>Based on: R. B. McGhee and A. A. Frank, "On the stability properties of quadruped creeping gaits" (1968), the margin of static stability, here over the height of the centre of mass.</remarks>
    public static ICriterion Stable { get; } = new StabilityCriterion();

    /// <summary>Height for its size: how high the highest joint of trunk, neck and head is. Giraffes rather than hippos; ears and horns do not count.</summary>
    public static ICriterion Tall { get; } = new TallnessCriterion();

    /// <summary>How far a creature comes for its work: 1 / <see cref="TransportCost"/> at its usual speed.</summary>
    public static ICriterion Efficient { get; } = new EconomyCriterion();

    /// <summary>How cleanly a creature moves, 0..1: 1 when no foot slips, no joint leaves its limits and no leg goes into another in any of its movements on flat ground, halved by each fault that one can just see.</summary>
    public static ICriterion Smooth { get; } = new SmoothnessCriterion();

    /// <summary>How different a creature is from those it lives with: its mean distance (<see cref="SpeciesDistance"/>) to the nearest of them. 1 for one that is alone.</summary>
    /// <remarks>Based on: J. Lehman and K. O. Stanley, "Abandoning objectives: evolution through the search for novelty alone" (2011), the measure of sparseness.</remarks>
    public static ICriterion Distinct { get; } = new DistinctnessCriterion();

    /// <summary>How far a creature is from any animal: parts of other animals than that which leads in its torso, bodies in the mix of its torso, proportions unlike theirs. Near 0 for an animal, 1 and more for what has no name.</summary>
    public static ICriterion Strange { get; } = new StrangenessCriterion();

    /// <summary>All of them.</summary>
    public static IReadOnlyList<ICriterion> All { get; } = new[] { Fast, Stable, Tall, Efficient, Smooth, Distinct, Strange };

    /// <summary>The one of a name; null if there is none.</summary>
    public static ICriterion? Find(string name) => All.FirstOrDefault(criterion => criterion.Name == name);
}
