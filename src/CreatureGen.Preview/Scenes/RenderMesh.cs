using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Scenes;

/// <summary>A surface ready to be drawn: arrays with one entry per vertex, and triangles counter-clockwise seen from outside. Model space, metres.</summary>
public sealed class RenderMesh
{
    // An eyeball is wet; lids and the skin around it belong to other joints.
    private const float EyeGloss = 1f;

    private readonly Vector3[] positions;
    private readonly Vector3[] normals;
    private readonly Vector3[] colours;
    private readonly int[] triangles;
    private readonly float[] gloss;
    private readonly Vector2[] texcoords;

    /// <summary>Takes ownership of the arrays.</summary>
    /// <param name="positions">Metres.</param>
    /// <param name="normals">Unit smooth normals.</param>
    /// <param name="colours">Linear RGB, 0..1.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="parts">The triangles by material, in order, covering all.</param>
    /// <param name="gloss">Gloss of each vertex, 0..1; null for that of the parts alone.</param>
    /// <param name="texcoords">Texture coordinates, origin at the top left of the texture; null when there is no texture.</param>
    /// <param name="texture">Colours that <paramref name="colours"/> are multiplied with; null for none.</param>
    /// <param name="normalMap">Normals in tangent space, as glTF has them; null for none.</param>
    /// <exception cref="ArgumentException">Arrays differ in length, a number is not finite, an index is out of range, or the parts do not cover the triangles.</exception>
    public RenderMesh(
        Vector3[] positions,
        Vector3[] normals,
        Vector3[] colours,
        int[] triangles,
        IReadOnlyList<RenderPart> parts,
        float[]? gloss = null,
        Vector2[]? texcoords = null,
        Texture? texture = null,
        Texture? normalMap = null)
    {
        this.positions = positions;
        this.normals = normals;
        this.colours = colours;
        this.triangles = triangles;
        this.gloss = gloss ?? [];
        this.texcoords = texcoords ?? [];
        Parts = parts;
        Texture = texture;
        NormalMap = normalMap;
        CheckLength(normals.Length, nameof(normals));
        CheckLength(colours.Length, nameof(colours));
        if (gloss is not null)
        {
            CheckLength(gloss.Length, nameof(gloss));
        }

        if (texcoords is not null || texture is not null || normalMap is not null)
        {
            CheckLength(this.texcoords.Length, nameof(texcoords));
        }

        CheckFinite(positions, nameof(positions));
        CheckFinite(normals, nameof(normals));
        CheckFinite(colours, nameof(colours));
        CheckFinite(this.gloss, nameof(gloss));
        CheckFinite(MemoryMarshal.Cast<Vector2, float>(this.texcoords), nameof(texcoords));
        CheckTriangles();
        Bounds = positions.Length == 0 ? default : BoundingBox.Of(positions);
    }

    /// <summary>Metres.</summary>
    public ReadOnlySpan<Vector3> Positions => positions;

    /// <summary>Unit smooth normals.</summary>
    public ReadOnlySpan<Vector3> Normals => normals;

    /// <summary>Linear RGB, 0..1.</summary>
    public ReadOnlySpan<Vector3> Colours => colours;

    /// <summary>Vertex indices, three per triangle.</summary>
    public ReadOnlySpan<int> Triangles => triangles;

    /// <summary>Gloss of each vertex, 0..1; empty when only the parts have gloss.</summary>
    public ReadOnlySpan<float> Gloss => gloss;

    /// <summary>Texture coordinates; empty when there is no texture.</summary>
    public ReadOnlySpan<Vector2> Texcoords => texcoords;

    /// <summary>The triangles by material, in order.</summary>
    public IReadOnlyList<RenderPart> Parts { get; }

    /// <summary>Colours that those of the vertices are multiplied with, or null.</summary>
    public Texture? Texture { get; }

    /// <summary>Normals in tangent space, or null.</summary>
    public Texture? NormalMap { get; }

    /// <summary>The smallest box around all positions.</summary>
    public BoundingBox Bounds { get; }

    /// <summary>The surface of a creature in rest pose.</summary>
    public static RenderMesh From(Creature creature)
    {
        ArgumentNullException.ThrowIfNull(creature);
        return From(creature, creature.Mesh.Positions, creature.Mesh.Normals);
    }

    /// <summary>The surface of a creature in another pose.</summary>
    /// <param name="creature">The creature.</param>
    /// <param name="posedPositions">Where its vertices are, model space, metres; one per vertex of its mesh. Copied.</param>
    /// <param name="posedNormals">Unit normals in that pose; one per vertex of its mesh. Copied.</param>
    /// <exception cref="ArgumentException">The arrays are not of the length of the mesh.</exception>
    public static RenderMesh From(Creature creature, ReadOnlySpan<Vector3> posedPositions, ReadOnlySpan<Vector3> posedNormals)
    {
        ArgumentNullException.ThrowIfNull(creature);
        CreatureMesh mesh = creature.Mesh;
        if (posedPositions.Length != mesh.Positions.Length || posedNormals.Length != mesh.Positions.Length)
        {
            throw new ArgumentException(
                FormattableString.Invariant($"{posedPositions.Length} positions and {posedNormals.Length} normals; expected {mesh.Positions.Length}, one per vertex of the creature's mesh"), nameof(posedPositions));
        }

        var parts = new List<RenderPart>(mesh.Parts.Count);
        foreach (MeshPart part in mesh.Parts)
        {
            parts.Add(new RenderPart(part.Material == MaterialKind.Membrane ? SurfaceMaterial.Membrane : SurfaceMaterial.Skin, part.FirstIndex, part.IndexCount));
        }

        var gloss = new float[mesh.Positions.Length];
        for (int i = 0; i < gloss.Length; i++)
        {
            gloss[i] = creature.Skeleton.Joints[mesh.Weights[i].Joint0].Role == JointRole.Eye ? EyeGloss : 0f;
        }

        return new RenderMesh(posedPositions.ToArray(), posedNormals.ToArray(), mesh.Colours.ToArray(), mesh.Triangles.ToArray(), parts, gloss, mesh.Texcoords.ToArray());
    }

    /// <summary>This surface with the colours of its vertices multiplied with those of a texture. The arrays are shared.</summary>
    /// <exception cref="ArgumentException">The mesh has no texture coordinates.</exception>
    public RenderMesh WithTexture(Texture texture) =>
        new(positions, normals, colours, triangles, Parts, gloss.Length == 0 ? null : gloss, texcoords, texture);

    /// <summary>This surface of a creature under its texture atlas: pieces set into the skin keep their colours, all else has those of the atlas, and its relief.</summary>
    /// <exception cref="ArgumentException">The mesh has no texture coordinates.</exception>
    public RenderMesh WithTextures(CreatureTextures textures)
    {
        ArgumentNullException.ThrowIfNull(textures);
        var tints = new Vector3[colours.Length];
        for (int i = 0; i < tints.Length; i++)
        {
            tints[i] = i < texcoords.Length && CreatureTextures.KeepsItsColour(texcoords[i]) ? colours[i] : Vector3.One;
        }

        var colour = new Texture(textures.BaseColour, textures.Size, textures.Size, TexelMeaning.Colour);
        var relief = new Texture(textures.Normal, textures.Size, textures.Size, TexelMeaning.Number);
        return new RenderMesh(positions, normals, tints, triangles, Parts, gloss.Length == 0 ? null : gloss, texcoords, colour, relief);
    }

    /// <summary>This surface in another pose. All other arrays, and the textures, are shared.</summary>
    /// <param name="posedPositions">Metres; taken over.</param>
    /// <param name="posedNormals">Unit normals; taken over.</param>
    /// <exception cref="ArgumentException">The arrays are not of the length of this one, or a number is not finite.</exception>
    public RenderMesh Posed(Vector3[] posedPositions, Vector3[] posedNormals)
    {
        ArgumentNullException.ThrowIfNull(posedPositions);
        ArgumentNullException.ThrowIfNull(posedNormals);
        if (posedPositions.Length != positions.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{posedPositions.Length} positions; expected {positions.Length}, one per vertex"), nameof(posedPositions));
        }

        return new RenderMesh(posedPositions, posedNormals, colours, triangles, Parts, gloss.Length == 0 ? null : gloss, texcoords.Length == 0 ? null : texcoords, Texture, NormalMap);
    }

    /// <summary>This surface of a creature and another one without textures, in one.</summary>
    /// <param name="other">Keeps the colours of its vertices.</param>
    public RenderMesh With(RenderMesh other)
    {
        ArgumentNullException.ThrowIfNull(other);
        int first = positions.Length;
        int[] added = Array.ConvertAll(other.triangles, vertex => vertex + first);
        var parts = new List<RenderPart>(Parts);
        foreach (RenderPart part in other.Parts)
        {
            parts.Add(part with { FirstIndex = part.FirstIndex + triangles.Length });
        }

        // The plain place of the atlas keeps the colours of vertices.
        var swatch = new Vector2[other.positions.Length];
        Array.Fill(swatch, CreatureTextures.PlainTexcoord);
        return new RenderMesh(
            [.. positions, .. other.positions],
            [.. normals, .. other.normals],
            [.. colours, .. other.colours],
            [.. triangles, .. added],
            parts,
            gloss.Length == 0 ? null : [.. gloss, .. new float[other.positions.Length]],
            texcoords.Length == 0 ? null : [.. texcoords, .. swatch],
            Texture,
            NormalMap);
    }

    private void CheckLength(int length, string name)
    {
        if (length != positions.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{length} {name}; expected {positions.Length}, one per position"), name);
        }
    }

    private static void CheckFinite(ReadOnlySpan<Vector3> values, string name)
    {
        for (int i = 0; i < values.Length; i++)
        {
            Vector3 v = values[i];
            if (!float.IsFinite(v.X) || !float.IsFinite(v.Y) || !float.IsFinite(v.Z))
            {
                throw new ArgumentException(FormattableString.Invariant($"{name}[{i}] = {v}; expected finite numbers"), name);
            }
        }
    }

    private static void CheckFinite(ReadOnlySpan<float> values, string name)
    {
        foreach (float value in values)
        {
            if (!float.IsFinite(value))
            {
                throw new ArgumentException(FormattableString.Invariant($"{value} among the {name}; expected finite numbers"), name);
            }
        }
    }

    private void CheckTriangles()
    {
        for (int i = 0; i < triangles.Length; i++)
        {
            if ((uint)triangles[i] >= (uint)positions.Length)
            {
                throw new ArgumentException(FormattableString.Invariant($"triangles[{i}] = {triangles[i]}; expected 0..{positions.Length - 1}"), nameof(triangles));
            }
        }

        int next = 0;
        foreach (RenderPart part in Parts)
        {
            if (part.FirstIndex != next || part.IndexCount < 0 || part.IndexCount % 3 != 0)
            {
                throw new ArgumentException(FormattableString.Invariant($"part starts at index {part.FirstIndex} with {part.IndexCount} indices; expected a multiple of 3 from {next}"), nameof(Parts));
            }

            next += part.IndexCount;
        }

        if (next != triangles.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"the parts cover {next} of {triangles.Length} indices; expected all"), nameof(Parts));
        }
    }
}
