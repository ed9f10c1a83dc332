using System;
using System.Buffers.Text;
using System.IO;
using System.IO.Compression;
using System.Text;
using CreatureGen.Blueprints;

namespace CreatureGen.Lab.Runtime;

/// <summary>A blueprint as letters that an address may hold: its text without blanks, compressed, in base64 of addresses.</summary>
internal static class AddressText
{
    private const int MostLetters = 8192;

    public static string Write(CreatureBlueprint design)
    {
        byte[] text = Encoding.UTF8.GetBytes(BlueprintJson.Write(design));
        using var packed = new MemoryStream();
        using (var deflate = new DeflateStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            deflate.Write(text);
        }

        return Base64Url.EncodeToString(packed.ToArray());
    }

    public static CreatureBlueprint Read(string address)
    {
        if (address.Length > MostLetters)
        {
            throw new ArgumentException(FormattableString.Invariant($"the address has {address.Length} letters; expected at most {MostLetters}"));
        }

        try
        {
            using var packed = new MemoryStream(Base64Url.DecodeFromChars(address));
            using var deflate = new DeflateStream(packed, CompressionMode.Decompress);
            byte[] text = new byte[BlueprintJson.MaximumBytes];
            int length = deflate.ReadAtLeast(text, text.Length, throwOnEndOfStream: false);
            return DesignText.Read(Encoding.UTF8.GetString(text, 0, length));
        }
        catch (Exception problem) when (problem is FormatException or InvalidDataException or InvalidOperationException or IOException)
        {
            throw new ArgumentException("the address is cut off or mistyped; expected one that this page made");
        }
    }
}
