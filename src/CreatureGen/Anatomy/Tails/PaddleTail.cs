namespace CreatureGen.Anatomy.Tails;

/// <summary>Newts and crocodiles: an upright blade along the rear two thirds that runs out in a point.</summary>
internal static class PaddleTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.15, 0.75, 0.85), (0.35, 0.5, 0.95), (0.55, 0.32, 1.2), (0.75, 0.2, 1), (0.9, 0.11, 0.5), (1, 0.06, 0.12)) { Length = 0.95 };
}
