using System;
using System.Collections.Generic;
using System.Numerics;
using System.Threading;
using CreatureGen.Geometry;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>Triangles of one material.</summary>
/// <param name="Material">How they are drawn.</param>
/// <param name="FirstIndex">First of their indices in <see cref="CreatureMesh.Triangles"/>.</param>
/// <param name="IndexCount">Number of their indices.</param>
public sealed record MeshPart(MaterialKind Material, int FirstIndex, int IndexCount);

/// <summary>
/// The vertex buffers of a creature in rest pose, model space, metres. All arrays but the triangles have one entry per vertex.
/// </summary>
/// <remarks>
/// Vertices are split where texture coordinates need it: vertices with equal positions are one point of the surface and have equal weights.
/// Triangles are counter-clockwise seen from outside.
/// </remarks>
public sealed class CreatureMesh
{
    private readonly Vector3[] positions;
    private readonly Vector3[] normals;
    private readonly Vector2[] texcoords;
    private readonly Vector3[] colours;
    private readonly SkinWeights[] weights;
    private readonly int[] triangles;
    private Vector4[] tangents = Array.Empty<Vector4>();
    private CreatureLods? levels;

    /// <summary>Takes ownership of the arrays.</summary>
    /// <exception cref="ArgumentException">Arrays differ in length, an index is out of range, or the parts do not cover the triangles.</exception>
    public CreatureMesh(Vector3[] positions, Vector3[] normals, Vector2[] texcoords, Vector3[] colours, SkinWeights[] weights, int[] triangles, IReadOnlyList<MeshPart> parts)
    {
        this.positions = positions;
        this.normals = normals;
        this.texcoords = texcoords;
        this.colours = colours;
        this.weights = weights;
        this.triangles = triangles;
        Parts = parts;
        if (normals.Length != positions.Length || texcoords.Length != positions.Length || colours.Length != positions.Length || weights.Length != positions.Length)
        {
            throw new ArgumentException("the vertex arrays differ in length; expected one entry per vertex in each");
        }

        foreach (int index in triangles)
        {
            if ((uint)index >= (uint)positions.Length)
            {
                throw new ArgumentException(FormattableString.Invariant($"triangle index {index}; expected 0..{positions.Length - 1}"), nameof(triangles));
            }
        }

        int next = 0;
        foreach (MeshPart part in parts)
        {
            if (part.FirstIndex != next || part.IndexCount <= 0 || part.IndexCount % 3 != 0)
            {
                throw new ArgumentException(FormattableString.Invariant($"part starts at index {part.FirstIndex} with {part.IndexCount} indices; expected a positive multiple of 3 from {next}"), nameof(parts));
            }

            next += part.IndexCount;
        }

        if (next != triangles.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"the parts cover {next} of {triangles.Length} indices; expected all"), nameof(parts));
        }
    }

    /// <summary>Positions, metres.</summary>
    public ReadOnlySpan<Vector3> Positions => positions;

    /// <summary>Unit smooth normals.</summary>
    public ReadOnlySpan<Vector3> Normals => normals;

    /// <summary>
    /// For each vertex the unit direction, perpendicular to the normal, in which u grows, and in w the side (±1) of the third axis, w · (normal × tangent), which points up the picture.
    /// Empty unless this is a mesh made by <see cref="Textured"/>.
    /// </summary>
    public ReadOnlySpan<Vector4> Tangents => tangents;

    /// <summary>Texture coordinates, 0..1, origin at the top left of the picture.</summary>
    public ReadOnlySpan<Vector2> Texcoords => texcoords;

    /// <summary>Linear RGB, 0..1.</summary>
    public ReadOnlySpan<Vector3> Colours => colours;

    /// <summary>Joint influences.</summary>
    public ReadOnlySpan<SkinWeights> Weights => weights;

    /// <summary>Vertex indices, three per triangle.</summary>
    public ReadOnlySpan<int> Triangles => triangles;

    /// <summary>The triangles by material, in order.</summary>
    public IReadOnlyList<MeshPart> Parts { get; }

    /// <summary>How much larger a viewer takes each vertex's piece for than it is; null when all are taken as they are.</summary>
    internal float[]? SimplificationWeight { get; init; }

    /// <summary>Coarser triangles over the same vertices. Made when first asked for.</summary>
    public CreatureLods Lods
    {
        get
        {
            // Threads that ask at the same time make the same levels; the first to finish is kept.
            CreatureLods? made = Volatile.Read(ref levels);
            return made ?? Interlocked.CompareExchange(ref levels, CreatureLods.Of(this), null) ?? levels;
        }
    }

    /// <summary>This mesh as it is drawn with its texture atlas: with <see cref="Tangents"/>, and white where the atlas has the colour.</summary>
    /// <remarks>Left and right share their texels. Along back and belly, where the texture turns over, vertices are there twice; those of this mesh come first, in their order. Levels of detail are made of the mesh before, each textured by itself.</remarks>
    public CreatureMesh Textured() => TexturedMesh.Of(this);

    /// <summary>The same mesh with tangents, one for each vertex.</summary>
    internal CreatureMesh With(Vector4[] otherTangents) => new(positions, normals, texcoords, colours, weights, triangles, Parts) { SimplificationWeight = SimplificationWeight, tangents = otherTangents };

    /// <summary>Other triangles over the same vertices, which are shared.</summary>
    internal CreatureMesh With(int[] otherTriangles, IReadOnlyList<MeshPart> otherParts) =>
        new(positions, normals, texcoords, colours, weights, otherTriangles, otherParts) { SimplificationWeight = SimplificationWeight, tangents = tangents };
}
