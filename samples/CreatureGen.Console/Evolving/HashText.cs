using System.Globalization;

namespace CreatureGen.Console.Evolving;

/// <summary>The numbers by which creatures are known, as 16 hexadecimal digits.</summary>
internal static class HashText
{
    /// <summary>Digits that are enough on a picture.</summary>
    private const int Short = 8;

    /// <summary>The digits of a number.</summary>
    public static string Of(ulong identity) => identity.ToString("x16", CultureInfo.InvariantCulture);

    /// <summary>The first of them.</summary>
    public static string ShortOf(ulong identity) => Of(identity)[..Short];

    /// <summary>Reads digits.</summary>
    public static bool TryRead(string? text, out ulong identity)
    {
        identity = 0;
        return text is { Length: 16 } && ulong.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out identity);
    }
}
