using System;
using System.Buffers.Binary;
using System.Buffers.Text;
using System.IO;
using System.IO.Compression;
using System.Text;
using CreatureGen.Blueprints;

namespace CreatureGen.Lab.Runtime;

/// <summary>
/// A blueprint as letters that an address may hold: its text without blanks, deflated (RFC 1951) after words that blueprints have in common, in base64 of addresses. The words themselves are left out: who reads puts them
/// before what is left, as a block that is not compressed. So they must stay as they are for as long as addresses are to be read.
/// </summary>
internal static class AddressText
{
    private const int MostLetters = 8192;
    private static readonly byte[] words = ReadWords();

    public static string Write(CreatureBlueprint design)
    {
        using var packed = new MemoryStream();
        long start;
        using (var deflate = new DeflateStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            deflate.Write(words);
            deflate.Flush();
            start = packed.Length;
            deflate.Write(Encoding.UTF8.GetBytes(ShortNumbers.WithoutBlanks(BlueprintJson.Write(design))));
        }

        return Base64Url.EncodeToString(packed.ToArray().AsSpan((int)start));
    }

    public static CreatureBlueprint Read(string address)
    {
        if (address.Length > MostLetters)
        {
            throw new ArgumentException(FormattableString.Invariant($"it has {address.Length} letters; expected at most {MostLetters}"));
        }

        try
        {
            using var packed = new MemoryStream();
            packed.Write(StoredHead(words.Length));
            packed.Write(words);
            packed.Write(Base64Url.DecodeFromChars(address));
            packed.Position = 0;
            using var deflate = new DeflateStream(packed, CompressionMode.Decompress);
            byte[] text = new byte[words.Length + (1 << 18)];
            int length = deflate.ReadAtLeast(text, text.Length, throwOnEndOfStream: false);
            return DesignText.Read(Encoding.UTF8.GetString(text, words.Length, length - words.Length));
        }
        catch (Exception problem) when (problem is FormatException or InvalidDataException or ArgumentOutOfRangeException or IOException)
        {
            throw new ArgumentException("it is cut off or mistyped; expected one that this page made");
        }
    }

    /// <summary>The head of a block that is stored as it is and is not the last.</summary>
    private static byte[] StoredHead(int length)
    {
        byte[] head = new byte[5];
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(1), checked((ushort)length));
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(3), (ushort)~length);
        return head;
    }

    private static byte[] ReadWords()
    {
        using Stream source = typeof(AddressText).Assembly.GetManifestResourceStream("address-words.txt")!;
        using var all = new MemoryStream();
        source.CopyTo(all);
        return all.ToArray();
    }
}
