namespace CreatureGen.Anatomy.Tails;

/// <summary>Sharks and sturgeons: the spine runs on into the upper half.</summary>
internal static class HeterocercalTail
{
    /// <summary>Its form.</summary>
    public static readonly TailFin Form = new() { Spread = 1.2, Halves = (1.35, 0.7), Upper = new[] { 0, 0.12, 0.42, 0.85, 1.15 }, Lower = new[] { 0, 0.02, 0.08, 0.2, 0.35 } };
}
