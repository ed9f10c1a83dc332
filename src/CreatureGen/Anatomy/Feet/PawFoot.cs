namespace CreatureGen.Anatomy.Feet;

/// <summary>Cats and bears: short round toes.</summary>
internal static class PawFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 1.25f, Splay = 0.75f, Radius = (1f, 1f, 1f) };
}
