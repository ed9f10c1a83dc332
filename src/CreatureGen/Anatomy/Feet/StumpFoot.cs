namespace CreatureGen.Anatomy.Feet;

/// <summary>Tapirs and hippopotamuses: a thick sole with nails.</summary>
internal static class StumpFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 0.42f, Splay = 0.75f, Radius = (1.3f, 1.3f, 1.25f), Nailed = true };
}
