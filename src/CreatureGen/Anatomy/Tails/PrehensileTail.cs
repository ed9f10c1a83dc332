namespace CreatureGen.Anatomy.Tails;

/// <summary>Chameleons and spider monkeys: strong to its end, which rolls up.</summary>
internal static class PrehensileTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.15, 0.66, 0.66), (0.3, 0.47, 0.47), (0.5, 0.34, 0.34), (0.75, 0.21, 0.21), (1, 0.05, 0.05)) { Length = 1.3, Curl = -99 };
}
