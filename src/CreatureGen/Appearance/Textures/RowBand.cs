namespace CreatureGen.Appearance.Textures;

/// <summary>Some whole rows of a picture, one below another. Bands of a picture can be painted side by side: no two share a texel.</summary>
/// <param name="Top">First row.</param>
/// <param name="End">The row after the last.</param>
internal readonly record struct RowBand(int Top, int End)
{
    /// <summary>How many bands a picture is painted in: enough that none keeps the others waiting for long, few enough that looking through all faces for each costs little.</summary>
    public const int Count = 8;

    /// <summary>A band of a picture.</summary>
    /// <param name="size">Rows of the picture.</param>
    /// <param name="number">0 up to <see cref="Count"/>, from the top.</param>
    public static RowBand Of(int size, int number) => new(size * number / Count, size * (number + 1) / Count);

    /// <summary>All rows of a picture.</summary>
    public static RowBand All(int size) => new(0, size);
}
