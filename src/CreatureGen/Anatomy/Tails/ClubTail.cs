namespace CreatureGen.Anatomy.Tails;

/// <summary>Ankylosaurs: a stiff stalk and a knob.</summary>
internal static class ClubTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.25, 0.66, 0.66), (0.5, 0.38, 0.38), (0.7, 0.2, 0.2), (0.8, 0.44, 0.34), (0.89, 0.64, 0.43), (1, 0.06, 0.06)) { Length = 0.9, Girth = 1.15 };
}
