using System;
using System.Linq;
using CreatureGen.Appearance.Textures;
using Xunit;

namespace CreatureGen.Tests.Appearance.Textures;

public sealed class EmbossingTests
{
    private const int Size = 32;
    private const float Texel = 0.25f;

    [Fact]
    public void An_even_slope_leans_every_normal_the_same_way_up_to_the_edges()
    {
        // Rises by a texel per texel from left to right: 45 degrees.
        float[] heights = Enumerable.Range(0, Size * Size).Select(at => Texel * (at % Size)).ToArray();
        byte[] normals = Normals(Enumerable.Repeat(true, Size * Size).ToArray(), heights);
        byte lean = (byte)(int)(128.5 - (127 / Math.Sqrt(2)));
        byte rise = (byte)(int)(128.5 + (127 / Math.Sqrt(2)));
        for (int at = 0; at < Size * Size; at++)
        {
            Assert.Equal([lean, 128, rise], normals[(3 * at)..((3 * at) + 3)]);
        }
    }

    [Fact]
    public void With_holes_in_it_every_normal_is_what_one_texel_after_the_other_gives()
    {
        var random = new Random(3);
        bool[] painted = Enumerable.Range(0, Size * Size).Select(at => at % 97 != 0 && at / Size != 20).ToArray();
        float[] heights = painted.Select(_ => random.NextSingle()).ToArray();
        byte[] normals = Normals(painted, heights);
        for (int at = 0; at < Size * Size; at++)
        {
            int x = at % Size;
            int y = at / Size;
            double du = Slope(x > 0, x < Size - 1, 1) / Texel;
            double dv = Slope(y > 0, y < Size - 1, Size) / Texel;
            double scale = 127 / Math.Sqrt(1 + (du * du) + (dv * dv));
            double[] expected = painted[at] ? [128 - (du * scale), 128 + (dv * scale), 128 + scale] : [0, 0, 0];
            for (int c = 0; c < 3; c++)
            {
                Assert.InRange(normals[(3 * at) + c], expected[c] - 0.51, expected[c] + 0.51);
            }

            double Slope(bool hasBefore, bool hasAfter, int stride) =>
                (hasBefore && painted[at - stride], hasAfter && painted[at + stride]) switch
                {
                    (true, true) => (heights[at + stride] - heights[at - stride]) / 2,
                    (true, false) => heights[at] - heights[at - stride],
                    (false, true) => heights[at + stride] - heights[at],
                    _ => 0,
                };
        }
    }

    private static byte[] Normals(bool[] painted, float[] heights)
    {
        byte[] normals = new byte[3 * Size * Size];
        new Embossing(painted, heights, normals, Size, Texel).Make(RowBand.All(Size));
        return normals;
    }
}
