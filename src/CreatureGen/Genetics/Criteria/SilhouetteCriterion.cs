using System;
using CreatureGen.Creatures;
using CreatureGen.Inspection.Variety;

namespace CreatureGen.Genetics.Criteria;

/// <summary>Likeness to an outline from the side, 0..1: the area that both cover over the area that either covers, drawn alike large. The outline may look to the left or to the right.</summary>
public sealed class SilhouetteCriterion : ICriterion
{
    private readonly Outline right;
    private readonly Outline left;

    /// <summary>Takes what is wanted.</summary>
    public SilhouetteCriterion(OutlineMask wanted)
    {
        _ = wanted ?? throw new ArgumentNullException(nameof(wanted));
        right = Outline.OfPicture(wanted.Width, wanted.Height, (x, y) => wanted[x, y]);
        left = Outline.OfPicture(wanted.Width, wanted.Height, (x, y) => wanted[wanted.Width - 1 - x, y]);
    }

    /// <inheritdoc/>
    public string Name => "like";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        CreatureMesh mesh = candidate.Creature.Mesh;
        Outline own = Outline.FromSide(mesh.Positions, mesh.Triangles);
        return Math.Max(own.Likeness(right), own.Likeness(left));
    }
}
