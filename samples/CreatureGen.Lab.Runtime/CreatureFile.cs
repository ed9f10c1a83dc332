using System;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Gltf;
using CreatureGen.Pictures;

namespace CreatureGen.Lab.Runtime;

/// <summary>Files that somebody drops on the page. They are not trusted.</summary>
internal static class CreatureFile
{
    public static CreatureBlueprint Read(byte[] file)
    {
        using var stream = new MemoryStream(file, writable: false);
        ReadOnlySpan<byte> start = file;
        return start.StartsWith("glTF"u8) ? DesignText.Require(GlbReader.ReadBlueprint(stream))
            : start.StartsWith<byte>([0x89, (byte)'P', (byte)'N', (byte)'G']) ? DesignText.Require(BlueprintPicture.Read(stream))
            : DesignText.Require(BlueprintJson.Read(stream));
    }

    public static byte[] Sign(byte[] picture, CreatureBlueprint design)
    {
        using var source = new MemoryStream(picture, writable: false);
        using var signed = new MemoryStream();
        BlueprintPicture.Write(source, design, signed);
        return signed.ToArray();
    }
}
