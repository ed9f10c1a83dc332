using System;
using System.Buffers;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>One level of detail of a creature: triangles over the vertices of its mesh, which all levels share.</summary>
public sealed class CreatureLod
{
    private readonly CreatureMesh mesh;
    private readonly int[] triangles;
    private readonly int[] remap;

    internal CreatureLod(CreatureMesh mesh, int[] triangles, IReadOnlyList<MeshPart> parts, int[] remap)
    {
        this.mesh = mesh;
        this.triangles = triangles;
        this.remap = remap;
        Parts = parts;
    }

    /// <summary>The mesh itself, in which each vertex stands for itself.</summary>
    internal static CreatureLod Finest(CreatureMesh mesh)
    {
        int[] remap = new int[mesh.Positions.Length];
        for (int v = 0; v < remap.Length; v++)
        {
            remap[v] = v;
        }

        return new CreatureLod(mesh, mesh.Triangles.ToArray(), mesh.Parts, remap);
    }

    /// <summary>The triangles of a mesh that are left when each vertex gives way to another.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="remap">What <see cref="Remap"/> says.</param>
    /// <param name="places">The place of each vertex, by number: triangles with two corners in one place have vanished.</param>
    internal static CreatureLod Of(CreatureMesh mesh, int[] remap, int[] places)
    {
        int[] triangles = ArrayPool<int>.Shared.Rent(mesh.Triangles.Length);
        var parts = new List<MeshPart>();
        int count = 0;
        foreach (MeshPart part in mesh.Parts)
        {
            int start = count;
            ReadOnlySpan<int> all = mesh.Triangles.Slice(part.FirstIndex, part.IndexCount);
            for (int c = 0; c < all.Length; c += 3)
            {
                int a = remap[all[c]], b = remap[all[c + 1]], d = remap[all[c + 2]];
                if (a >= 0 && places[a] != places[b] && places[b] != places[d] && places[d] != places[a])
                {
                    triangles[count] = a;
                    triangles[count + 1] = b;
                    triangles[count + 2] = d;
                    count += 3;
                }
            }

            if (count > start)
            {
                parts.Add(new MeshPart(part.Material, start, count - start));
            }
        }

        // Steps have left gaps in the order in which the surface was grown.
        int[] left = new int[count];
        foreach (MeshPart part in parts)
        {
            VertexCacheOrder.Triangles(mesh.Positions.Length, triangles.AsSpan(part.FirstIndex, part.IndexCount), left.AsSpan(part.FirstIndex, part.IndexCount));
        }

        ArrayPool<int>.Shared.Return(triangles);
        return new CreatureLod(mesh, left, parts, remap);
    }

    /// <summary>Indices of vertices of the creature's mesh, three per triangle, counter-clockwise seen from outside.</summary>
    public ReadOnlySpan<int> Triangles => triangles;

    /// <summary>The triangles by material, in order.</summary>
    public IReadOnlyList<MeshPart> Parts { get; }

    /// <summary>
    /// For each vertex of the creature's mesh the vertex that stands for it in this level: itself when it is kept, −1 when it was part of a piece, such as a claw, that this level leaves out.
    /// Moving each vertex of a finer level to its own in this one is a continuous change from the one to the other.
    /// </summary>
    public ReadOnlySpan<int> Remap => remap;

    /// <summary>A mesh of this level alone, with the vertices that it uses in their order.</summary>
    public CreatureMesh ToMesh()
    {
        int[] index = new int[remap.Length];
        Array.Fill(index, -1);
        foreach (int v in triangles)
        {
            index[v] = 0;
        }

        int count = 0;
        for (int v = 0; v < index.Length; v++)
        {
            index[v] = index[v] < 0 ? -1 : count++;
        }

        var positions = new Vector3[count];
        var normals = new Vector3[count];
        var texcoords = new Vector2[count];
        var colours = new Vector3[count];
        var weights = new SkinWeights[count];
        float[]? simplificationWeight = mesh.SimplificationWeight is null ? null : new float[count];
        for (int v = 0; v < index.Length; v++)
        {
            int at = index[v];
            if (at >= 0)
            {
                positions[at] = mesh.Positions[v];
                normals[at] = mesh.Normals[v];
                texcoords[at] = mesh.Texcoords[v];
                colours[at] = mesh.Colours[v];
                weights[at] = mesh.Weights[v];
                if (simplificationWeight != null)
                {
                    simplificationWeight[at] = mesh.SimplificationWeight![v];
                }
            }
        }

        return new CreatureMesh(positions, normals, texcoords, colours, weights, Array.ConvertAll(triangles, v => index[v]), Parts) { SimplificationWeight = simplificationWeight };
    }
}
