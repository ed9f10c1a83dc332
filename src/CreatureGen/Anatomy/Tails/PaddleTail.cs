namespace CreatureGen.Anatomy.Tails;

/// <summary>Newts and crocodiles: an upright blade along the rear two thirds.</summary>
internal static class PaddleTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.15, 0.8, 0.85), (0.35, 0.55, 1.05), (0.6, 0.38, 1.75), (0.8, 0.28, 1.6), (1, 0.12, 0.4)) { Length = 0.95 };
}
