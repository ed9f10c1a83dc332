using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Rendering;

/// <summary>How much of the key light reaches points of the creature past the creature itself.</summary>
/// <remarks>Percentage-closer filtering (Reeves, Salesin and Cook 1987) over a square of texels with its edge texels weighted by the part inside.</remarks>
internal sealed class ShadowMap
{
    // Texels on each side of the one that holds the point.
    private const int Radius = 2;

    private readonly HeightRaster raster;
    private readonly float bias;

    public ShadowMap(HeightRaster raster)
    {
        this.raster = raster;

        // Along a surface that is 45° to the light height changes by a texel per texel; steeper ones are dark by their normal.
        bias = raster.TexelSize * 1.5f;
    }

    /// <summary>The part of the key light, 0..1, that reaches a point with the given unit normal.</summary>
    public float Light(Vector3 point, Vector3 normal)
    {
        Vector3 lifted = point + (normal * (raster.TexelSize * (Radius + 0.5f)));
        float height = Vec.Dot(lifted, raster.Direction) + bias;
        raster.Locate(lifted, out float u, out float v);
        u -= 0.5f;
        v -= 0.5f;
        int size = raster.Size;
        int x = (int)MathF.Floor(u);
        int y = (int)MathF.Floor(v);
        if (x < Radius || y < Radius || x + Radius + 1 >= size || y + Radius + 1 >= size)
        {
            return 1f;
        }

        float fu = u - x;
        float fv = v - y;
        float[] heights = raster.Highest;
        float sum = 0f;
        for (int j = -Radius; j <= Radius + 1; j++)
        {
            ReadOnlySpan<float> row = heights.AsSpan(((y + j) * size) + x - Radius, (2 * Radius) + 2);
            float inRow = (row[0] <= height ? 1f - fu : 0f) + (row[^1] <= height ? fu : 0f);
            for (int i = 1; i < row.Length - 1; i++)
            {
                inRow += row[i] <= height ? 1f : 0f;
            }

            sum += inRow * (j == -Radius ? 1f - fv : j == Radius + 1 ? fv : 1f);
        }

        const float Width = (2 * Radius) + 1;
        return sum * (1f / (Width * Width));
    }
}
