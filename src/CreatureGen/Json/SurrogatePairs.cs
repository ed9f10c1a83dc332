namespace CreatureGen.Json;

/// <summary>Finds text that has no UTF-8.</summary>
internal static class SurrogatePairs
{
    /// <summary>Index of the first half of a pair without its other half; −1 if there is none.</summary>
    public static int IndexOfLoneHalf(string text)
    {
        for (int i = 0; i < text.Length; i++)
        {
            if (!char.IsSurrogate(text[i]))
            {
                continue;
            }

            if (!char.IsHighSurrogate(text[i]) || i + 1 == text.Length || !char.IsLowSurrogate(text[i + 1]))
            {
                return i;
            }

            i++;
        }

        return -1;
    }
}
