namespace CreatureGen.Anatomy.Feet;

/// <summary>Eagles: slender toes with long claws, one of them behind.</summary>
internal static class TalonFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new() { Length = 1.15f, Splay = 1.25f, Radius = (0.85f, 0.85f, 0.9f), Hallux = 0.62f };
}
