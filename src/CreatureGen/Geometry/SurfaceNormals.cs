using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Normals of a triangle mesh.</summary>
internal static class SurfaceNormals
{
    /// <summary>Unit smooth normals, weighted by area.</summary>
    public static void Smooth(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, Span<Vector3> normals)
    {
        normals.Clear();
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 a = positions[triangles[t]];
            Vector3 n = Vec.Cross(positions[triangles[t + 1]] - a, positions[triangles[t + 2]] - a);
            normals[triangles[t]] += n;
            normals[triangles[t + 1]] += n;
            normals[triangles[t + 2]] += n;
        }

        for (int v = 0; v < normals.Length; v++)
        {
            normals[v] = Vec.Normalize(normals[v] * 1e4f, Vector3.UnitY);
        }
    }
}
