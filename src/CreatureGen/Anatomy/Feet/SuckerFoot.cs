namespace CreatureGen.Anatomy.Feet;

/// <summary>Tree frogs and geckos: thin toes that end in discs.</summary>
internal static class SuckerFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 1.3f, Splay = 1.35f, Radius = (0.75f, 0.6f, 2f) };
}
