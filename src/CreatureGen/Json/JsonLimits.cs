using System;

namespace CreatureGen.Json;

/// <summary>What a reader accepts at most, so that hostile text costs bounded time and memory.</summary>
internal readonly struct JsonLimits
{
    /// <summary>Arrays and objects inside one another.</summary>
    public const int MaximumDepth = 64;

    /// <summary>Limits of the given size.</summary>
    /// <param name="maximumBytes">Length of the text in UTF-8.</param>
    /// <param name="maximumValues">Number of values, containers included.</param>
    public JsonLimits(int maximumBytes, int maximumValues)
    {
        if (maximumBytes < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(maximumBytes), "expected at least 1 byte");
        }

        if (maximumValues < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(maximumValues), "expected at least 1 value");
        }

        MaximumBytes = maximumBytes;
        MaximumValues = maximumValues;
    }

    /// <summary>For documents that a person may write: 4 MiB and 100 000 values.</summary>
    public static JsonLimits Document => new(4 << 20, 100_000);

    /// <summary>For text made by machines, such as the JSON chunk of a GLB file: 64 MiB and 4 million values.</summary>
    public static JsonLimits Bulk => new(64 << 20, 4_000_000);

    /// <summary>Length of the text in UTF-8.</summary>
    public int MaximumBytes { get; }

    /// <summary>Number of values, containers included.</summary>
    public int MaximumValues { get; }
}
