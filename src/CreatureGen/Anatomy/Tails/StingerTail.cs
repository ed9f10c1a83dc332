namespace CreatureGen.Anatomy.Tails;

/// <summary>Scorpions: a row of beads and a bulb, carried over the back.</summary>
internal static class StingerTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.2, 0.7, 0.7), (0.45, 0.54, 0.54), (0.68, 0.38, 0.38), (0.8, 0.5, 0.5), (0.89, 0.42, 0.42), (1, 0.16, 0.16)) { Length = 1.2, Girth = 1.2, Curl = -99, Beads = 0.2 };
}
