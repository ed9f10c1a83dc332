namespace CreatureGen.Anatomy.Tails;

/// <summary>Ankylosaurs: a stiff stalk and a knob.</summary>
internal static class ClubTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.25, 0.68, 0.68), (0.5, 0.4, 0.4), (0.7, 0.28, 0.28), (0.8, 0.62, 0.46), (0.9, 0.92, 0.58), (1, 0.42, 0.32)) { Length = 0.9, Girth = 1.15 };
}
