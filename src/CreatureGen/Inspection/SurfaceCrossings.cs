namespace CreatureGen.Inspection;

/// <summary>Where a surface cuts through itself, in pairs of triangles that share no vertex.</summary>
/// <param name="Body">On the body and its limbs.</param>
/// <param name="Pieces">Each within one of the pieces that are set into the skin: horns, claws, teeth, eyes, locks of hair, thin wings. That a piece cuts into the skin below it or into its neighbours is how it is set, and does not count.</param>
public readonly record struct SurfaceCrossings(int Body, int Pieces)
{
    /// <summary>Both together.</summary>
    public int All => Body + Pieces;
}
