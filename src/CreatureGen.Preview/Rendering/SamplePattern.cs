using System;

namespace CreatureGen.Preview.Rendering;

/// <summary>Places of samples within a pixel, in 1/256 pixel from its middle, y down.</summary>
internal sealed class SamplePattern
{
    // The standard patterns of Direct3D 11, in 1/16 pixel.
    private static readonly SamplePattern Single = new([0], [0]);
    private static readonly SamplePattern Quad = new([-2, 6, -6, 2], [-6, -2, 2, 6]);
    private static readonly SamplePattern Octet = new([1, -1, 5, -3, -5, -7, 3, 7], [-3, 3, 1, -5, 5, -1, 7, -7]);

    private SamplePattern(int[] sixteenthsX, int[] sixteenthsY)
    {
        Count = sixteenthsX.Length;
        X = Array.ConvertAll(sixteenthsX, x => x * 16);
        Y = Array.ConvertAll(sixteenthsY, y => y * 16);
    }

    public int Count { get; }

    public int[] X { get; }

    public int[] Y { get; }

    /// <summary>All samples of a pixel as a mask.</summary>
    public int All => (1 << Count) - 1;

    public static SamplePattern Of(SampleCount count) => count switch
    {
        SampleCount.One => Single,
        SampleCount.Four => Quad,
        SampleCount.Eight => Octet,
        _ => throw new ArgumentOutOfRangeException(nameof(count), count, "expected One, Four or Eight"),
    };
}
