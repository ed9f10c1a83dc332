namespace CreatureGen.Anatomy.Tails;

/// <summary>Ankylosaurs: a stiff stalk and a knob.</summary>
internal static class ClubTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.25, 0.68, 0.68), (0.5, 0.42, 0.42), (0.7, 0.32, 0.32), (0.8, 0.75, 0.6), (0.9, 1.15, 0.8), (1, 0.6, 0.5)) { Length = 0.9, Girth = 1.15 };
}
