using System;
using System.Numerics;
using CreatureGen.Appearance.Textures;
using Xunit;

namespace CreatureGen.Tests.Appearance.Textures;

public sealed class AtlasPicturesTests
{
    private const int Size = 256;

    [Theory]
    [InlineData(100, 100)]
    [InlineData(103, 96)]
    [InlineData(104, 96)]
    [InlineData(0, 10)]
    [InlineData(Size - 1, 10)]
    [InlineData(5, 0)]
    [InlineData(Size - 1, Size - 1)]
    public void Colour_bleeds_as_far_as_asked_and_never_around_an_edge(int x, int y)
    {
        const int Far = 3;
        using var pictures = new AtlasPictures(Size);
        pictures.Set(x, y, new Vector3(1f, 0f, 0f), 0f, 0.5f, 1f);
        pictures.Bleed(Far);
        for (int at = 0; at < Size * Size; at++)
        {
            int steps = Math.Abs((at % Size) - x) + Math.Abs((at / Size) - y);
            Assert.True(steps <= Far == pictures.IsPainted(at % Size, at / Size), $"texel {at % Size}, {at / Size}, {steps} steps away");
            Assert.Equal(steps <= Far ? 255 : 128, pictures.BaseColour[3 * at]);
        }
    }
}
