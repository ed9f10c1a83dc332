namespace CreatureGen.Anatomy.Tails;

/// <summary>Mice and iguanas: a thread.</summary>
internal static class WhipTail
{
    /// <summary>Its form.</summary>
    public static readonly TailTaper Form = new((0, 1, 1), (0.1, 0.72, 0.72), (0.25, 0.48, 0.48), (0.5, 0.28, 0.28), (0.75, 0.15, 0.15), (1, 0.06, 0.06)) { Length = 1.45 };
}
