namespace CreatureGen.Anatomy.Tails;

/// <summary>Bass and trout: cut off straight.</summary>
internal static class TruncateTail
{
    /// <summary>Its form.</summary>
    public static readonly TailFin Form = new() { Spread = 0.9, Halves = (0.85, 0.85), Upper = new[] { 0, 0, 0, 0.02, 0.06 }, Lower = new[] { 0, 0, 0, 0.02, 0.06 } };
}
