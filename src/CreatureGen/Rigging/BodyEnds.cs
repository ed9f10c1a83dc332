using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>The vertices at the tip of the head and at the tip of the tail, found on the surface.</summary>
/// <remarks>
/// After the thesis: of the vertices near the mesh's centre in x and y, the two farthest apart; the head is the one in front.
/// "Near the centre" is measured within each section of the body, since a bent body leaves the middle of its mesh: a vertex counts when it lies within
/// <see cref="Band"/> of the section's half width and half height from the spine. The flanks of a body never do, whatever its shape; its two ends always do.
/// </remarks>
internal readonly struct BodyEnds
{
    /// <summary>Share of a section's extent in which a vertex counts as near its centre.</summary>
    private const float Band = 0.35f;

    private BodyEnds(int head, int tail)
    {
        Head = head;
        Tail = tail;
    }

    /// <summary>Vertex at the tip of the head.</summary>
    public int Head { get; }

    /// <summary>Vertex at the tip of the tail.</summary>
    public int Tail { get; }

    /// <summary>Finds both ends.</summary>
    /// <exception cref="ArgumentException">The surface has fewer than two vertices near the spine.</exception>
    public static BodyEnds Find(Surface surface, BodyShape shape)
    {
        var candidates = new List<int>(64);
        for (int v = 0; v < surface.Positions.Length; v++)
        {
            if (IsCentral(surface.Positions[v], surface.Addresses[v], shape))
            {
                candidates.Add(v);
            }
        }

        int first = -1;
        int second = -1;
        float farthest = -1f;
        for (int i = 0; i < candidates.Count; i++)
        {
            Vector3 p = surface.Positions[candidates[i]];
            for (int k = i + 1; k < candidates.Count; k++)
            {
                float squared = Vec.LengthSquared(surface.Positions[candidates[k]] - p);
                if (squared > farthest)
                {
                    farthest = squared;
                    first = candidates[i];
                    second = candidates[k];
                }
            }
        }

        if (first < 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"the surface has {candidates.Count} vertices near the spine; expected closed ends at the head and the tail"), nameof(surface));
        }

        return surface.Positions[first].Z >= surface.Positions[second].Z ? new BodyEnds(first, second) : new BodyEnds(second, first);
    }

    private static bool IsCentral(Vector3 p, in VertexAddress address, BodyShape shape)
    {
        if (address.Appendage >= 0 || address.Region is SurfaceRegion.Lip or SurfaceRegion.Mouth)
        {
            return false;
        }

        int ring = Math.Min(Math.Max((int)address.Ring, 0), BodyGrid.Rings - 1);
        if (Math.Abs(p.X) > Band * shape.Width[ring])
        {
            return false;
        }

        float height = Vec.Dot(p - shape.Centre(ring), shape.Up(ring));
        return height > 0f ? height <= Band * shape.Top[ring] : -height <= Band * shape.Bottom[ring];
    }
}
