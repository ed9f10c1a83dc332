using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Creatures;

/// <summary>The skin of the front of a muzzle as it is seen from ahead.</summary>
internal sealed class MuzzleFront
{
    private readonly NosePad pad;
    private readonly List<(Vector3 A, Vector3 B, Vector3 C)> triangles = new();

    /// <summary>Finds it.</summary>
    public MuzzleFront(Surface surface, NosePad pad)
    {
        this.pad = pad;
        ReadOnlySpan<int> corners = surface.Triangles;
        for (int t = 0; t < corners.Length; t += 3)
        {
            VertexAddress address = surface.Addresses[corners[t]];
            if (address.Ring <= StationRing.MuzzleFront && address.Appendage < 0)
            {
                triangles.Add((surface.Positions[corners[t]], surface.Positions[corners[t + 1]], surface.Positions[corners[t + 2]]));
            }
        }
    }

    /// <summary>How far the skin is ahead of a place of the pad's plane, metres: where it is met first from ahead; 0 beside the muzzle.</summary>
    /// <param name="at">The place.</param>
    public float Ahead(Vector3 at)
    {
        float farthest = 0f;
        foreach ((Vector3 first, Vector3 second, Vector3 third) in triangles)
        {
            (Vector3 a, Vector3 b, Vector3 c) = (first - at, second - at, third - at);
            Vector2 p = Seen(a), q = Seen(b), r = Seen(c);

            // Areas of the triangles that the place makes with the edges, as seen from ahead: where all are of one sign, it lies within.
            float u = Area(q, r), v = Area(r, p), w = Area(p, q);
            float whole = u + v + w;
            if (whole == 0f || u / whole < 0f || v / whole < 0f || w / whole < 0f)
            {
                continue;
            }

            farthest = Math.Max(farthest, Vec.Dot(((a * u) + (b * v) + (c * w)) / whole, pad.Forward));
        }

        return farthest;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector2 Seen(Vector3 point) => new(point.X, Vec.Dot(point, pad.Up));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Area(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
