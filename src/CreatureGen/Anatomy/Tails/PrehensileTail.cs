namespace CreatureGen.Anatomy.Tails;

/// <summary>Chameleons and spider monkeys: strong to its end, which rolls up.</summary>
internal static class PrehensileTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.25, 0.74, 0.74), (0.5, 0.52, 0.52), (0.75, 0.34, 0.34), (1, 0.13, 0.13)) { Length = 1.3, Curl = -99 };
}
