using System;
using System.Globalization;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;

namespace CreatureGen.Console.Files;

/// <summary>Arrays of numbers as files that NumPy and its like read.</summary>
/// <remarks>The format NPY 1.0 (numpy.lib.format), little-endian, rows first.</remarks>
internal static class NumberArray
{
    private const int Alignment = 64;

    /// <summary>An array of 32-bit floats.</summary>
    public static byte[] Of(ReadOnlySpan<float> numbers, params ReadOnlySpan<int> shape) => Write("<f4", MemoryMarshal.AsBytes(numbers), shape);

    /// <summary>An array of 16-bit floats.</summary>
    public static byte[] Of(ReadOnlySpan<Half> numbers, params ReadOnlySpan<int> shape) => Write("<f2", MemoryMarshal.AsBytes(numbers), shape);

    /// <summary>An array of 16-bit whole numbers from 0 on.</summary>
    public static byte[] Of(ReadOnlySpan<ushort> numbers, params ReadOnlySpan<int> shape) => Write("<u2", MemoryMarshal.AsBytes(numbers), shape);

    private static byte[] Write(string type, ReadOnlySpan<byte> content, ReadOnlySpan<int> shape)
    {
        if (!BitConverter.IsLittleEndian)
        {
            throw new PlatformNotSupportedException("arrays are written on machines that keep the low byte first");
        }

        var sides = new StringBuilder();
        foreach (int side in shape)
        {
            sides.Append(CultureInfo.InvariantCulture, $"{side},");
        }

        // Magic, version and the length of what follows take ten bytes; spaces fill up to the alignment.
        string header = $"{{'descr': '{type}', 'fortran_order': False, 'shape': ({sides}), }}";
        int length = ((10 + header.Length + 1 + Alignment - 1) / Alignment * Alignment) - 10;
        var file = new MemoryStream();
        file.Write([0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0, (byte)length, (byte)(length >> 8)]);
        file.Write(Encoding.ASCII.GetBytes(header.PadRight(length - 1) + "\n"));
        file.Write(content);
        return file.ToArray();
    }
}
