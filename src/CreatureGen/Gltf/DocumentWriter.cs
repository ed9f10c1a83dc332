using System.Collections.Generic;
using System.Globalization;
using System.Numerics;
using System;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Json;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf;

/// <summary>The JSON of a file, property by property in a fixed order.</summary>
internal static class DocumentWriter
{
    /// <summary>The name under which the library keeps what is its own in the asset's extras.</summary>
    public const string ExtrasName = "creaturegen";

    /// <summary>The name of the blueprint among them.</summary>
    public const string BlueprintName = "blueprint";

    /// <summary>Of dry skin; nothing is polished.</summary>
    private const float Roughness = 0.75f;

    private const int ArrayBuffer = 34962;
    private const int ElementArrayBuffer = 34963;

    /// <summary>Writes the whole document.</summary>
    public static void Write(JsonWriter json, Creature creature, GltfOptions options, BufferPlan plan, LodStack levels, MeshBuffers buffers, ClipBuffers clips, (Vector3 Min, Vector3 Max) box)
    {
        List<MaterialKind> materials = Materials(levels.Mesh);
        json.BeginObject();
        WriteAsset(json, creature.Blueprint, options);
        if (levels.Count > 1)
        {
            json.Name("extensionsUsed").BeginArray().Text(NodeTree.LevelExtension).EndArray();
        }

        json.Name("scene").Number(0);
        json.Name("scenes").BeginArray().BeginObject();
        json.Name("nodes").BeginArray().Number(NodeTree.MeshNode).Number(NodeTree.FirstJointNode).EndArray();
        json.EndObject().EndArray();
        json.Name("nodes");
        NodeTree.Write(json, creature, levels.Count, () => ClipWriter.WriteMirror(json, clips, options.Engine));
        json.Name("meshes").BeginArray();
        for (int i = 0; i < levels.Count; i++)
        {
            WriteMesh(json, levels, i, buffers, materials);
        }

        json.EndArray();
        WriteSkin(json, creature.Skeleton.Joints.Count, buffers);
        json.Name("materials").BeginArray();
        foreach (MaterialKind material in materials)
        {
            WriteMaterial(json, material, NameOf(material, options.Materials), plan.Blocks.Count > 0);
        }

        json.EndArray();
        if (plan.Blocks.Count > 0)
        {
            TextureWriter.Write(json, plan);
        }

        if (clips.Clips.Count > 0)
        {
            ClipWriter.Write(json, clips, options.Engine);
        }

        WriteAccessors(json, plan, buffers.Positions, clips, box);
        WriteBufferViews(json, plan);
        json.Name("buffers").BeginArray().BeginObject().Name("byteLength").Number(plan.ByteLength).EndObject().EndArray();
        json.EndObject();
    }

    private static void WriteAsset(JsonWriter json, CreatureBlueprint blueprint, GltfOptions options)
    {
        json.Name("asset").BeginObject();
        json.Name("version").Text("2.0");
        json.Name("generator").Text("CreatureGen");
        json.Name("extras").BeginObject().Name(ExtrasName).BeginObject();
        json.Name("seed").Text(blueprint.Seed.ToString(CultureInfo.InvariantCulture));
        json.Name("algorithmVersion").Number(CreatureBlueprint.CurrentAlgorithm);
        if (options.Provenance != null)
        {
            json.Name("options").Text(options.Provenance);
        }

        if (options.Lods != LodChoice.Finest)
        {
            json.Name("levels").Text(options.Lods.ToString().ToLowerInvariant());
        }

        if (options.Materials != MaterialChoice.Two)
        {
            json.Name("materials").Text(options.Materials.ToString().ToLowerInvariant());
        }

        if (options.TextureSize != 0)
        {
            json.Name("textureSize").Number(options.TextureSize);
        }

        if (options.Clips.Count > 0)
        {
            WriteClipChoices(json, options);
        }

        json.Name(BlueprintName);
        WriteBlueprint(json, blueprint);
        json.EndObject().EndObject().EndObject();
    }

    private static void WriteClipChoices(JsonWriter json, GltfOptions options)
    {
        if (options.ClipPrecision is not { } precision)
        {
            json.Name("keys").Text("every frame");
        }
        else if (precision != ClipPrecision.Default)
        {
            json.Name("keys").BeginObject();
            json.Name("error").Number(precision.Error);
            json.Name("distance").Number(precision.Distance);
            json.Name("interpolation").Text(precision.Interpolation.ToString().ToLowerInvariant());
            json.EndObject();
        }

        if (options.RootMotion != RootMotionChoice.InPlace)
        {
            json.Name("rootMotion").Text(options.RootMotion.ToString().ToLowerInvariant());
        }

        if (options.Engine != TargetEngine.Generic)
        {
            json.Name("engine").Text(options.Engine.ToString().ToLowerInvariant());
        }
    }

    private static void WriteBlueprint(JsonWriter json, CreatureBlueprint blueprint)
    {
        try
        {
            BlueprintJson.Write(json, blueprint);
        }
        catch (ArgumentException e)
        {
            throw ExportError.At("the blueprint", e.Message, "one that can be kept as text");
        }
    }

    private static void WriteMesh(JsonWriter json, LodStack levels, int level, MeshBuffers buffers, List<MaterialKind> materials)
    {
        json.BeginObject();
        json.Name("name").Text(NodeTree.NameOfLevel(level));
        json.Name("primitives").BeginArray();
        (int first, int count) = levels.PartsOf(level);
        for (int i = first; i < first + count; i++)
        {
            json.BeginObject();
            json.Name("attributes").BeginObject();
            json.Name("POSITION").Number(buffers.Positions.Index);
            json.Name("NORMAL").Number(buffers.Normals.Index);
            if (buffers.Tangents != null)
            {
                json.Name("TANGENT").Number(buffers.Tangents.Index);
            }

            json.Name("TEXCOORD_0").Number(buffers.Texcoords.Index);
            json.Name("COLOR_0").Number(buffers.Colours.Index);
            json.Name("JOINTS_0").Number(buffers.Joints.Index);
            json.Name("WEIGHTS_0").Number(buffers.Weights.Index);
            json.EndObject();
            json.Name("indices").Number(buffers.Indices[i].Index);
            json.Name("material").Number(materials.IndexOf(levels.Mesh.Parts[i].Material));
            json.EndObject();
        }

        json.EndArray();
        json.EndObject();
    }

    private static void WriteSkin(JsonWriter json, int jointCount, MeshBuffers buffers)
    {
        json.Name("skins").BeginArray().BeginObject();
        json.Name("name").Text("Skeleton");
        json.Name("inverseBindMatrices").Number(buffers.InverseBinds.Index);
        json.Name("skeleton").Number(NodeTree.FirstJointNode);
        json.Name("joints").BeginArray();
        for (int i = 0; i < jointCount; i++)
        {
            json.Number(NodeTree.FirstJointNode + i);
        }

        json.EndArray();
        json.EndObject().EndArray();
    }

    /// <summary>Writes a material. All colour is in the vertices or the atlas, so that the base colour is white.</summary>
    private static void WriteMaterial(JsonWriter json, MaterialKind material, string name, bool textured)
    {
        json.BeginObject();
        json.Name("name").Text(name);
        json.Name("pbrMetallicRoughness").BeginObject();
        json.Name("baseColorFactor").BeginArray().Number(1).Number(1).Number(1).Number(1).EndArray();
        json.Name("metallicFactor").Number(0);
        json.Name("roughnessFactor").Number(textured ? 1 : Roughness);
        if (textured)
        {
            TextureWriter.Refer(json, "baseColorTexture", TextureImages.BaseColour);
            TextureWriter.Refer(json, "metallicRoughnessTexture", TextureImages.Roughness);
        }

        json.EndObject();
        if (textured)
        {
            TextureWriter.Refer(json, "normalTexture", TextureImages.Normal);
            TextureWriter.Refer(json, "occlusionTexture", TextureImages.Roughness);
        }

        if (material == MaterialKind.Membrane)
        {
            json.Name("doubleSided").Boolean(true);
        }

        json.EndObject();
    }

    private static string NameOf(MaterialKind material, MaterialChoice choice) =>
        choice == MaterialChoice.One ? "Creature" : material == MaterialKind.Membrane ? "Membrane" : "Skin";

    private static void WriteAccessors(JsonWriter json, BufferPlan plan, Accessor positions, ClipBuffers clips, (Vector3 Min, Vector3 Max) box)
    {
        json.Name("accessors").BeginArray();
        foreach (Accessor accessor in plan.Accessors)
        {
            json.BeginObject();
            json.Name("bufferView").Number(accessor.Index);
            json.Name("componentType").Number(ComponentType(accessor.Format));
            if (accessor.Format == ComponentFormat.ShortFraction)
            {
                json.Name("normalized").Boolean(true);
            }

            json.Name("count").Number(accessor.Count);
            json.Name("type").Text(ElementType(accessor.Shape));
            if (accessor == positions)
            {
                json.Name("min").Vector(box.Min);
                json.Name("max").Vector(box.Max);
            }
            else if (clips.LastTime(accessor) is float seconds)
            {
                json.Name("min").BeginArray().Number(0).EndArray();
                json.Name("max").BeginArray().Number(seconds).EndArray();
            }

            json.EndObject();
        }

        json.EndArray();
    }

    private static void WriteBufferViews(JsonWriter json, BufferPlan plan)
    {
        json.Name("bufferViews").BeginArray();
        foreach (Accessor accessor in plan.Accessors)
        {
            json.BeginObject();
            json.Name("buffer").Number(0);
            json.Name("byteOffset").Number(accessor.Offset);
            json.Name("byteLength").Number(accessor.ByteLength);
            if (accessor.Target != BufferTarget.None)
            {
                json.Name("target").Number(accessor.Target == BufferTarget.Vertices ? ArrayBuffer : ElementArrayBuffer);
            }

            json.EndObject();
        }

        foreach ((int offset, int byteLength) in plan.Blocks)
        {
            json.BeginObject();
            json.Name("buffer").Number(0);
            json.Name("byteOffset").Number(offset);
            json.Name("byteLength").Number(byteLength);
            json.EndObject();
        }

        json.EndArray();
    }

    private static List<MaterialKind> Materials(CreatureMesh mesh)
    {
        var materials = new List<MaterialKind>();
        foreach (MeshPart part in mesh.Parts)
        {
            if (!materials.Contains(part.Material))
            {
                materials.Add(part.Material);
            }
        }

        return materials;
    }

    private static int ComponentType(ComponentFormat format) => format switch
    {
        ComponentFormat.Byte => 5121,
        ComponentFormat.Short or ComponentFormat.ShortFraction => 5123,
        ComponentFormat.Integer => 5125,
        _ => 5126,
    };

    private static string ElementType(ElementShape shape) => shape switch
    {
        ElementShape.Scalar => "SCALAR",
        ElementShape.Vector2 => "VEC2",
        ElementShape.Vector3 => "VEC3",
        ElementShape.Vector4 => "VEC4",
        _ => "MAT4",
    };
}
