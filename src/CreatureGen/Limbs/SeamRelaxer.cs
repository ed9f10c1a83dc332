using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Smooths the surface where limbs grow out of the body: uniform Laplacian steps on the socket's border and two rings on either side of it.</summary>
internal static class SeamRelaxer
{
    private const int Iterations = 8;
    private const float Border = 0.55f;
    private const float FirstRing = 0.4f;
    private const float SecondRing = 0.18f;

    /// <summary>Moves the points of the surface in place; left and right stay exact mirror images.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="adjacency">Its neighbourhoods.</param>
    /// <param name="borders">Vertices of the socket borders of the left side and the midline.</param>
    public static void Relax(Surface surface, SurfaceAdjacency adjacency, IEnumerable<int> borders)
    {
        float[] strength = new float[surface.Positions.Length];
        var selected = new List<int>();
        foreach (int v in borders)
        {
            Select(strength, selected, v, Border);
            Select(strength, selected, surface.Mirror[v], Border);
        }

        int begin = 0;
        foreach (float ring in stackalloc float[] { FirstRing, SecondRing })
        {
            int end = selected.Count;
            for (int i = begin; i < end; i++)
            {
                foreach (int n in adjacency.Of(selected[i]))
                {
                    Select(strength, selected, n, ring);
                }
            }

            begin = end;
        }

        foreach (int v in selected)
        {
            strength[v] *= Fraction(surface.Addresses[v].Region);
        }

        var moved = new Vector3[selected.Count];
        for (int round = 0; round < Iterations; round++)
        {
            for (int i = 0; i < selected.Count; i++)
            {
                int v = selected[i];
                if (surface.Addresses[v].Sign < 0)
                {
                    continue;
                }

                Vector3 sum = Vector3.Zero;
                foreach (int n in adjacency.Of(v))
                {
                    sum += surface.Positions[n];
                }

                moved[i] = Vec.Lerp(surface.Positions[v], sum / adjacency.Of(v).Length, strength[v]);
            }

            for (int i = 0; i < selected.Count; i++)
            {
                int v = selected[i];
                if (surface.Addresses[v].Sign < 0)
                {
                    continue;
                }

                Vector3 p = moved[i];
                p.X = surface.Mirror[v] == v ? 0f : p.X;

                // A sole stays on the ground.
                p.Y = surface.Positions[v].Y == 0f ? 0f : p.Y;
                surface.Positions[v] = p;
                surface.Positions[surface.Mirror[v]] = surface.Mirror[v] == v ? p : Vec.Mirror(p);
            }
        }
    }

    private static void Select(float[] strength, List<int> selected, int vertex, float value)
    {
        if (strength[vertex] == 0f)
        {
            strength[vertex] = value;
            selected.Add(vertex);
        }
    }

    private static float Fraction(SurfaceRegion region) => region switch
    {
        SurfaceRegion.Fin or SurfaceRegion.Wing => 0.35f,
        SurfaceRegion.Ear or SurfaceRegion.EarInside => 0.3f,
        SurfaceRegion.Toe => 0.5f,
        SurfaceRegion.Mouth or SurfaceRegion.Lip => 0f,
        _ => 1f,
    };
}
