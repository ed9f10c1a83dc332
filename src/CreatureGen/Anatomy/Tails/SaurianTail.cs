namespace CreatureGen.Anatomy.Tails;

/// <summary>Lizards and dinosaurs: as thick as the rump ends, and from there evenly down to a point.</summary>
internal static class SaurianTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.2, 0.83, 0.83), (0.45, 0.56, 0.56), (0.7, 0.31, 0.31), (0.88, 0.15, 0.15), (1, 0.05, 0.05));
}
