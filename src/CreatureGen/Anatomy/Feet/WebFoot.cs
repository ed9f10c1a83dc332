namespace CreatureGen.Anatomy.Feet;

/// <summary>Ducks and otters: long spread toes in a web.</summary>
internal static class WebFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 1.3f, Splay = 1.45f, Radius = (0.9f, 0.75f, 0.8f), Web = 0.86f };
}
