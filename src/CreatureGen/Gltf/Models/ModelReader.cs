using System;
using System.IO;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Gltf.Models;

/// <summary>Reads skinned characters from binary glTF 2.0 files of any program: skeleton, skin, clips and spring bones; of the core features all that bears on them.</summary>
/// <remarks>
/// <para>Joints are the nodes that skins name and all nodes above them, with those of spring bones (<c>VRMC_springBone</c>). Their scale, the same along all axes, is worked into positions. Skinned meshes become one, of up to four joints per vertex. Materials, textures, morph
/// targets, cameras and meshes without a skin are passed over, and stay in the file that <see cref="ModelWriter"/> writes back.</para>
/// <para>Refused are files whose buffers lie elsewhere, extensions that change what is read here (compression), scale that differs between axes, and skins that contradict each other.</para>
/// Based on: Khronos Group, "glTF 2.0 Specification" (2021).
/// </remarks>
public static class ModelReader
{
    /// <summary>Most bytes of the binary chunk: 512 MiB.</summary>
    private const int MaxBinary = 1 << 29;

    /// <summary>Reads a model. Whatever the bytes are, the answer is a model or a report.</summary>
    /// <param name="source">A GLB file, read from the stream's position on; need not be able to seek, is not closed.</param>
    /// <exception cref="ArgumentNullException">The stream is null.</exception>
    /// <exception cref="ArgumentException">The stream cannot be read.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public static ModelReading Read(Stream source)
    {
        _ = source ?? throw new ArgumentNullException(nameof(source));
        if (!source.CanRead)
        {
            throw new ArgumentException("the stream cannot be read", nameof(source));
        }

        byte[]? text = GlbContainer.ReadJson(source, JsonLimits.Bulk.MaximumBytes, out Problem? problem);
        byte[]? binary = text is null ? null : GlbContainer.ReadBinary(source, MaxBinary, out problem);
        if (binary is null)
        {
            return new ModelReading(null, problem);
        }

        var problems = new ProblemList("JSON chunk");
        JsonValue? root = RecordJson.Parse(JsonReader.Read(text, JsonLimits.Bulk), problems);
        if (root is null)
        {
            return new ModelReading(null, problems.All[0]);
        }

        try
        {
            RequireCore(root);
            var document = new ModelDocument(root, binary);
            ModelJoints joints = ModelJoints.Of(document);
            return new ModelReading(new SkinnedModel(document, joints, ModelSkin.Of(document, joints), ModelClips.Of(document, joints), VrmSprings.Of(document, joints)), null);
        }
        catch (ModelFault fault)
        {
            return new ModelReading(null, fault.Problem);
        }
    }

    /// <summary>Materials and their textures do not matter here, and quantised meshes are read as any others.</summary>
    private static void RequireCore(JsonValue root)
    {
        foreach (JsonValue name in ModelDocument.ItemsOf(root, "extensionsRequired"))
        {
            if (name.Text != "KHR_mesh_quantization" && !name.Text.StartsWith("KHR_materials_", StringComparison.Ordinal) && !name.Text.StartsWith("KHR_texture_", StringComparison.Ordinal))
            {
                throw ModelFault.At(name, "a file without compressed or foreign parts");
            }
        }

        JsonValue version = ModelDocument.Need(ModelDocument.Need(root, "asset", "a version"), "version", "2.0");
        if (!version.Text.StartsWith("2.", StringComparison.Ordinal))
        {
            throw ModelFault.At(version, "2.0");
        }
    }
}
