using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>From the perceptual colours of blueprints to the linear RGB of vertices.</summary>
/// <remarks>
/// Based on: B. Ottosson, "A perceptual color space for image processing" (2020), matrices as revised 2021-01-25. Linear RGB has the primaries and
/// the white of sRGB. Colours outside its gamut keep lightness and hue and lose chroma; channels are never clamped one by one, which would shift the hue.
/// </remarks>
internal static class OklchColour
{
    // How far a channel may leave 0..1 unnoticed: far less than the darkest colours differ by.
    private const double GamutSlack = 1e-6;
    private const int BisectionSteps = 24;

    /// <summary>Linear RGB, each channel 0..1, of a colour of a blueprint.</summary>
    public static Vector3 ToLinearRgb(ColourBlueprint colour) => ToLinearRgb(colour.Lightness, colour.Chroma, colour.Hue);

    /// <summary>Linear RGB, each channel 0..1, of lightness 0..1, chroma and hue in radians.</summary>
    public static Vector3 ToLinearRgb(double lightness, double chroma, double hue)
    {
        if (lightness <= 0)
        {
            return Vector3.Zero;
        }

        if (lightness >= 1)
        {
            return Vector3.One;
        }

        double a = PortableMath.Cos(hue);
        double b = PortableMath.Sin(hue);
        Unclipped(lightness, chroma * a, chroma * b, out double red, out double green, out double blue);
        if (!InGamut(red, green, blue))
        {
            double inside = 0;
            double outside = chroma;
            for (int i = 0; i < BisectionSteps; i++)
            {
                double middle = 0.5 * (inside + outside);
                Unclipped(lightness, middle * a, middle * b, out red, out green, out blue);
                if (InGamut(red, green, blue))
                {
                    inside = middle;
                }
                else
                {
                    outside = middle;
                }
            }

            Unclipped(lightness, inside * a, inside * b, out red, out green, out blue);
        }

        return new Vector3((float)Scalar.Clamp(red, 0, 1), (float)Scalar.Clamp(green, 0, 1), (float)Scalar.Clamp(blue, 0, 1));
    }

    private static bool InGamut(double red, double green, double blue) =>
        red >= -GamutSlack && green >= -GamutSlack && blue >= -GamutSlack
        && red <= 1 + GamutSlack && green <= 1 + GamutSlack && blue <= 1 + GamutSlack;

    private static void Unclipped(double lightness, double a, double b, out double red, out double green, out double blue)
    {
        double l = lightness + (0.3963377774 * a) + (0.2158037573 * b);
        double m = lightness - (0.1055613458 * a) - (0.0638541728 * b);
        double s = lightness - (0.0894841775 * a) - (1.2914855480 * b);
        l = l * l * l;
        m = m * m * m;
        s = s * s * s;
        red = (4.0767416621 * l) - (3.3077115913 * m) + (0.2309699292 * s);
        green = (-1.2684380046 * l) + (2.6097574011 * m) - (0.3413193965 * s);
        blue = (-0.0041960863 * l) - (0.7034186147 * m) + (1.7076147010 * s);
    }
}
