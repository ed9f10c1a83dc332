using System;
using System.Buffers;
using System.IO;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Json;

namespace CreatureGen.Gltf;

/// <summary>Writes creatures as binary glTF 2.0 (GLB), core features only unless levels of detail are asked for, one creature to a file.</summary>
/// <remarks>
/// The scene has two roots: the node <c>Creature</c> with the skinned mesh, and the root joint. Every joint is a node of its own name; attachment
/// points are leaves of their joints, turned so that their +Y is the outward direction of the skin. Lengths are in metres, +Y is up, the creature faces +Z.
/// <para>
/// What glTF has no place for is in extras: on joints <c>colliders</c> (capsules in the joint's space); on attachment points <c>socket</c>
/// (<c>normal</c> in model space, <c>width</c>); on the root joint <c>body</c> (its capsule), <c>limbs</c>, <c>massProperties</c>, <c>standingHeight</c> and <c>defaultSpeed</c>, in model space;
/// and on the asset <c>creaturegen</c> with the seed, the version of the algorithm, the options and the blueprint, which <see cref="GlbReader"/> reads back.
/// </para>
/// <para>
/// With <see cref="LodChoice.All"/> the node <c>Creature</c> has the extension <c>MSFT_lod</c>, which names the nodes <c>Creature_LOD1</c> to <c>Creature_LOD3</c>; these are in no scene,
/// and their meshes share the vertices and the skin of the first.
/// </para>
/// <para>The bytes depend on nothing but the arguments. Safe to call from several threads at once, with different streams.</para>
/// Based on: Khronos Group, "glTF 2.0 Specification" (2021); Microsoft, "MSFT_lod" (glTF vendor extension).
/// </remarks>
public static class GlbWriter
{
    /// <summary>Writes a creature. Nothing is written if it throws <see cref="InvalidOperationException"/>.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="options">How it is written.</param>
    /// <param name="destination">Takes the bytes; is neither flushed nor closed.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The destination cannot be written to, the size of textures is out of its range, or the shading, the choice of levels or that of materials is none of the known ones.</exception>
    /// <exception cref="InvalidOperationException">The creature holds something that a file must not, such as a number that is not finite or weights that do not sum to one. The message says what and where.</exception>
    public static void Write(Creature creature, GltfOptions options, Stream destination)
    {
        _ = creature ?? throw new ArgumentNullException(nameof(creature));
        _ = options ?? throw new ArgumentNullException(nameof(options));
        _ = destination ?? throw new ArgumentNullException(nameof(destination));
        if (!destination.CanWrite)
        {
            throw new ArgumentException("the stream cannot be written to", nameof(destination));
        }

        ExportCheck.Require(creature);
        LodStack levels = LodStack.Of(creature.Mesh, options);
        CreatureTextures? textures = options.Textures ?? (options.TextureSize == 0 ? null : CreatureTextures.Bake(creature, options.TextureSize));
        TextureImages? images = textures == null ? null : TextureImages.Of(textures);
        levels = images == null ? levels : levels.Over(levels.Mesh.Textured());
        var plan = new BufferPlan();
        var buffers = new MeshBuffers(levels.Mesh, creature.Skeleton, plan);
        var clips = new ClipBuffers(options, creature.Skeleton, plan);
        foreach (byte[] file in images?.Files ?? Array.Empty<byte[]>())
        {
            plan.AddBlock(file.Length);
        }

        byte[] rented = ArrayPool<byte>.Shared.Rent(plan.ByteLength);
        try
        {
            Span<byte> binary = rented.AsSpan(0, plan.ByteLength);
            plan.Pad(binary);
            (Vector3 Min, Vector3 Max) box = buffers.Write(binary);
            clips.Write(binary);
            for (int i = 0; i < plan.Blocks.Count; i++)
            {
                images!.Files[i].CopyTo(binary.Slice(plan.Blocks[i].Offset));
            }

            using var json = new JsonWriter(JsonLayout.Compact);
            DocumentWriter.Write(json, creature, options with { TextureSize = textures?.Size ?? 0 }, plan, levels, buffers, clips, box);
            GlbContainer.Write(destination, json.Utf8, binary);
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(rented);
        }
    }
}
