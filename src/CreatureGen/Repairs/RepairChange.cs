namespace CreatureGen.Repairs;

/// <summary>Something that a repair changed in a blueprint.</summary>
/// <param name="Path">The field, as in the text of the blueprint: <c>legs[1].shear</c>.</param>
/// <param name="From">What it was.</param>
/// <param name="To">What it is now.</param>
/// <param name="Reason">Why, in a sentence without its full stop.</param>
public sealed record RepairChange(string Path, string From, string To, string Reason)
{
    /// <summary>The change as a sentence: <c>body.elevation: 0.4 became 0.52, the lowest point was 0.11 m below the ground</c>.</summary>
    public override string ToString() => Path + ": " + From + " became " + To + ", " + Reason;
}
