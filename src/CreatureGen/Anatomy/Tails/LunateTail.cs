namespace CreatureGen.Anatomy.Tails;

/// <summary>Tunas and swordfish: a crescent on a narrow stalk.</summary>
internal static class LunateTail
{
    /// <summary>Its form.</summary>
    public static readonly TailFin Form = new() { Spread = 2.2, Halves = (1.15, 1.1), Upper = new[] { 0, 0.06, 0.2, 0.42, 0.75 }, Lower = new[] { 0, 0.06, 0.2, 0.42, 0.75 } };
}
