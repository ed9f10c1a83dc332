namespace CreatureGen.Anatomy.Tails;

/// <summary>Chameleons and spider monkeys: strong to its end, which rolls up.</summary>
internal static class PrehensileTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.25, 0.8, 0.8), (0.5, 0.6, 0.6), (0.75, 0.44, 0.44), (1, 0.24, 0.24)) { Length = 1.3, Curl = -99 };
}
