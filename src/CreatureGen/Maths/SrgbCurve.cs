using System;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>The transfer curve of sRGB (IEC 61966-2-1) between linear light and encoded bytes.</summary>
internal static class SrgbCurve
{
    // At the dark end one step of the table is 0.2 of a byte, so that rounding is right nearly everywhere.
    private const int Steps = 16384;

    private static readonly byte[] Encoded = MakeEncoded();
    private static readonly float[] Decoded = MakeDecoded();

    /// <summary>The byte for linear light, which is clamped to 0..1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static byte Encode(float linear)
    {
        float scaled = (linear * (Steps - 1)) + 0.5f;
        return scaled >= Steps - 1 ? (byte)255 : scaled > 0f ? Encoded[(int)scaled] : (byte)0;
    }

    /// <summary>The linear light of a byte, 0..1.</summary>
    public static float Decode(byte encoded) => Decoded[encoded];

    private static byte[] MakeEncoded()
    {
        var table = new byte[Steps];
        for (int i = 0; i < Steps; i++)
        {
            double x = i / (double)(Steps - 1);
            double y = x <= 0.0031308 ? 12.92 * x : (1.055 * PortableMath.Pow(x, 1 / 2.4)) - 0.055;
            table[i] = (byte)Math.Floor((y * 255) + 0.5);
        }

        return table;
    }

    private static float[] MakeDecoded()
    {
        var table = new float[256];
        for (int i = 0; i < table.Length; i++)
        {
            double y = i / 255.0;
            table[i] = (float)(y <= 0.04045 ? y / 12.92 : PortableMath.Pow((y + 0.055) / 1.055, 2.4));
        }

        return table;
    }
}
