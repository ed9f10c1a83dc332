namespace CreatureGen.Anatomy.Feet;

/// <summary>Cows, pigs and deer: a hoof in two halves.</summary>
internal static class ClovenFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Cleft = 0.62f };
}
