using System;
using System.Globalization;

namespace CreatureGen.Console.Arguments;

/// <summary>Seeds as people write them.</summary>
internal static class SeedText
{
    /// <summary>What is expected of a seed, as a message says it.</summary>
    public const string Expectation = "a whole number 0..18446744073709551615, or hexadecimal digits after 0x";

    /// <summary>Reads a seed in decimal, or in hexadecimal after <c>0x</c>.</summary>
    public static bool TryRead(ReadOnlySpan<char> text, out ulong seed) =>
        text.StartsWith("0x", StringComparison.OrdinalIgnoreCase)
            ? ulong.TryParse(text[2..], NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out seed)
            : ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out seed);

    /// <summary>A seed in decimal.</summary>
    public static string Of(ulong seed) => seed.ToString(CultureInfo.InvariantCulture);
}
