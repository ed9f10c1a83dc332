using System;
using System.Collections.Generic;
using System.Numerics;
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
