using System;
using System.Numerics;
using CreatureGen.Geometry;

namespace CreatureGen.Appearance.Textures;

/// <summary>The coat at the vertices of a surface, folded onto the left side: worked out once for each, however many faces meet there.</summary>
internal sealed class VertexCoat
{
    private readonly CoatPainter coat;
    private readonly Surface surface;
    private readonly Vector3[] normals;
    private readonly float[] openness;
    private readonly CoatRange[] ranges;
    private readonly bool[] known;

    /// <summary>Prepares the coat of a surface.</summary>
    /// <param name="coat">The coat.</param>
    /// <param name="surface">The surface.</param>
    /// <param name="normals">Its smooth normals, one for each vertex.</param>
    /// <param name="openness">The share of the light from all around that comes to each vertex, 0..1.</param>
    public VertexCoat(CoatPainter coat, Surface surface, Vector3[] normals, float[] openness)
    {
        this.coat = coat;
        this.surface = surface;
        this.normals = normals;
        this.openness = openness;
        ranges = new CoatRange[normals.Length];
        known = new bool[normals.Length];
    }

    /// <summary>Rest position on the left side.</summary>
    public Vector3 PositionOf(int vertex)
    {
        Vector3 p = surface.Positions[vertex];
        return new Vector3(Math.Abs(p.X), p.Y, p.Z);
    }

    /// <summary>The share of the light from all around that comes to it, 0..1.</summary>
    public float OpennessOf(int vertex) => openness[vertex];

    private Vector3 NormalOf(int vertex)
    {
        Vector3 n = normals[vertex];
        return new Vector3(n.X * surface.Addresses[vertex].Sign, n.Y, n.Z);
    }

    /// <summary>The colours between which the pattern goes.</summary>
    public CoatRange RangeOf(int vertex)
    {
        if (!known[vertex])
        {
            known[vertex] = true;
            ranges[vertex] = coat.RangeAt(surface.Addresses[vertex], PositionOf(vertex), NormalOf(vertex));
        }

        return ranges[vertex];
    }
}
