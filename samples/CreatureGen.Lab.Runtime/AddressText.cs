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
    private const int MaxLetters = 2000;
    private static readonly byte[] words = ReadWords();

    /// <summary>The letters of a blueprint.</summary>
    /// <param name="design">Which.</param>
    /// <param name="like">A blueprint that whoever reads has, too: what is the same in it costs next to nothing. Null for none.</param>
    public static string Write(CreatureBlueprint design, CreatureBlueprint? like)
    {
        using var packed = new MemoryStream();
        long start;
        using (var deflate = new DeflateStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
        {
            deflate.Write(Known(like));
            deflate.Flush();
            start = packed.Length;
            deflate.Write(Encoding.UTF8.GetBytes(ShortNumbers.WithoutBlanks(BlueprintJson.Write(design))));
        }

        return Base64Url.EncodeToString(packed.ToArray().AsSpan((int)start));
    }

    /// <summary>The blueprint of letters.</summary>
    /// <param name="address">The letters.</param>
    /// <param name="like">The blueprint that was given when they were written.</param>
    public static CreatureBlueprint Read(string address, CreatureBlueprint? like)
    {
        if (address.Length > MaxLetters)
        {
            throw new ArgumentException(FormattableString.Invariant($"it has {address.Length} letters; expected at most {MaxLetters}"));
        }

        try
        {
            byte[] known = Known(like);
            using var packed = new MemoryStream();
            for (int at = 0; at < known.Length; at += ushort.MaxValue)
            {
                int length = Math.Min(ushort.MaxValue, known.Length - at);
                packed.Write(StoredHead(length));
                packed.Write(known, at, length);
            }

            packed.Write(Base64Url.DecodeFromChars(address));
            packed.Position = 0;
            using var deflate = new DeflateStream(packed, CompressionMode.Decompress);
            byte[] text = new byte[known.Length + (1 << 18)];
            int read = deflate.ReadAtLeast(text, text.Length, throwOnEndOfStream: false);
            return DesignText.Read(Encoding.UTF8.GetString(text, known.Length, read - known.Length));
        }
        catch (Exception problem) when (problem is FormatException or InvalidDataException or ArgumentOutOfRangeException or IOException)
        {
            throw new ArgumentException("it is cut off or mistyped; expected one that this page made");
        }
    }

    private static byte[] Known(CreatureBlueprint? like) =>
        like == null ? words : [.. words, .. Encoding.UTF8.GetBytes(ShortNumbers.WithoutBlanks(BlueprintJson.Write(like)))];

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
