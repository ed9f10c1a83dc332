namespace CreatureGen.Anatomy.Feet;

/// <summary>Tapirs and hippopotamuses: a thick sole with nails.</summary>
internal static class StumpFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 0.8f, Splay = 0.85f, Radius = (1.2f, 1.15f, 1f), Nailed = true };
}
