using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>Linear light as bytes of the sRGB transfer curve (IEC 61966-2-1).</summary>
internal static class SrgbBytes
{
    private const int Steps = 16384;
    private static readonly byte[] encoded = MakeTable();

    /// <summary>The byte for linear light, which is clamped to 0..1.</summary>
    public static byte Encode(float linear)
    {
        float scaled = (linear * (Steps - 1)) + 0.5f;
        return scaled >= Steps - 1 ? (byte)255 : scaled > 0f ? encoded[(int)scaled] : (byte)0;
    }

    private static byte[] MakeTable()
    {
        byte[] table = new byte[Steps];
        for (int i = 0; i < Steps; i++)
        {
            double x = i / (double)(Steps - 1);
            double y = x <= 0.0031308 ? 12.92 * x : (1.055 * PortableMath.Pow(x, 1 / 2.4)) - 0.055;
            table[i] = (byte)Math.Floor((y * 255) + 0.5);
        }

        return table;
    }
}
