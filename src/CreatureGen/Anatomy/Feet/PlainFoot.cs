namespace CreatureGen.Anatomy.Feet;

/// <summary>Toes as the form of the leg gives them.</summary>
internal static class PlainFoot
{
    /// <summary>Its form.</summary>
    public static readonly FootForm Form = new();
}
