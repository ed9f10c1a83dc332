namespace CreatureGen.Anatomy.Tails;

/// <summary>Fighting fish: a wide veil with a ragged edge.</summary>
internal static class VeilTail
{
    /// <summary>Its form.</summary>
    public static readonly TailFin Form = new() { Spread = 0.75, Halves = (1.3, 1.3), Upper = new[] { 0.3, 0.15, 0.32, 0.12, 0.05 }, Lower = new[] { 0.3, 0.15, 0.34, 0.14, 0.2 } };
}
