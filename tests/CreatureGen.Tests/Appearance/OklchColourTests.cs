using System;
using System.Numerics;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class OklchColourTests
{
    // CSS Color Module Level 4: the sRGB primaries and secondaries in OKLCH.
    [Theory]
    [InlineData(1.0, 0.0, 0.0, 1, 1, 1)]
    [InlineData(0.0, 0.0, 0.0, 0, 0, 0)]
    [InlineData(0.627955, 0.257683, 29.2339, 1, 0, 0)]
    [InlineData(0.866440, 0.294827, 142.4953, 0, 1, 0)]
    [InlineData(0.452014, 0.313214, 264.0520, 0, 0, 1)]
    [InlineData(0.967983, 0.211006, 109.7692, 1, 1, 0)]
    [InlineData(0.905399, 0.154550, 194.7690, 0, 1, 1)]
    [InlineData(0.701674, 0.322491, 328.3634, 1, 0, 1)]
    [InlineData(0.5, 0.0, 123.0, 0.125, 0.125, 0.125)]
    public void Published_colours_come_out(double lightness, double chroma, double degrees, double red, double green, double blue)
    {
        Vector3 rgb = OklchColour.ToLinearRgb(new ColourBlueprint(lightness, chroma, degrees * Math.PI / 180));
        Assert.Equal(red, rgb.X, 1e-3);
        Assert.Equal(green, rgb.Y, 1e-3);
        Assert.Equal(blue, rgb.Z, 1e-3);
    }

    [Fact]
    public void Every_colour_is_in_gamut_and_keeps_lightness_and_hue()
    {
        for (double lightness = 0.05; lightness < 1; lightness += 0.05)
        {
            for (double chroma = 0; chroma <= 0.4; chroma += 0.04)
            {
                for (int degrees = 0; degrees < 360; degrees += 15)
                {
                    double hue = degrees * Math.PI / 180;
                    Vector3 rgb = OklchColour.ToLinearRgb(lightness, chroma, hue);
                    Assert.InRange(Math.Min(rgb.X, Math.Min(rgb.Y, rgb.Z)), 0f, 1f);
                    Assert.InRange(Math.Max(rgb.X, Math.Max(rgb.Y, rgb.Z)), 0f, 1f);
                    (double l, double a, double b) = ToOklab(rgb);
                    double c = Math.Sqrt((a * a) + (b * b));
                    Assert.Equal(lightness, l, 4e-3);
                    Assert.True(c <= chroma + 4e-3, "chroma is never raised");

                    // Distance from the hue's own ray, which also holds for greys.
                    Assert.Equal(0.0, (a * Math.Sin(hue)) - (b * Math.Cos(hue)), 4e-3);
                }
            }
        }
    }

    [Fact]
    public void Colours_within_the_gamut_keep_their_chroma()
    {
        (double _, double a, double b) = ToOklab(OklchColour.ToLinearRgb(0.6, 0.1, 1.0));
        Assert.Equal(0.1, Math.Sqrt((a * a) + (b * b)), 1e-4);
    }

    [Fact]
    public void Lightness_beyond_the_ends_is_black_or_white()
    {
        Assert.Equal(Vector3.One, OklchColour.ToLinearRgb(1.2, 0.1, 0));
        Assert.Equal(Vector3.Zero, OklchColour.ToLinearRgb(-0.1, 0.1, 0));
    }

    // The forward transform of Ottosson's article.
    private static (double L, double A, double B) ToOklab(Vector3 rgb)
    {
        double l = Math.Cbrt((0.4122214708 * rgb.X) + (0.5363325363 * rgb.Y) + (0.0514459929 * rgb.Z));
        double m = Math.Cbrt((0.2119034982 * rgb.X) + (0.6806995451 * rgb.Y) + (0.1073969566 * rgb.Z));
        double s = Math.Cbrt((0.0883024619 * rgb.X) + (0.2817188376 * rgb.Y) + (0.6299787005 * rgb.Z));
        return (
            (0.2104542553 * l) + (0.7936177850 * m) - (0.0040720468 * s),
            (1.9779984951 * l) - (2.4285922050 * m) + (0.4505937099 * s),
            (0.0259040371 * l) + (0.7827717662 * m) - (0.8086757660 * s));
    }
}
