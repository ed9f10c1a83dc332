using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Whether the edge of a blade keeps off the flank that it grows out of.</summary>
internal static class FlankClearance
{
    // Points of the edge that are looked at, from where it leaves the root, and rings of the flank behind the socket.
    private const float EdgeFrom = 0.1f;
    private const int EdgePoints = 6;
    private const int Rings = 20;

    /// <summary>Whether all points are outside the skin by a margin, as the nearest point of the grid faces.</summary>
    /// <param name="skin">The skin of the body.</param>
    /// <param name="ring">Where the blade grows out of it.</param>
    /// <param name="edge">The edge at a share of the span, 0..1, on the left.</param>
    /// <param name="margin">Metres.</param>
    public static bool Has(BodySkin skin, double ring, Func<float, Vector3> edge, float margin)
    {
        for (int k = 0; k <= EdgePoints; k++)
        {
            Vector3 point = edge(Scalar.Lerp(EdgeFrom, 1f, (float)k / EdgePoints));
            SurfacePoint at = Nearest(skin, (int)ring, point);
            if (Vec.Dot(point - at.Position, at.Normal) < margin)
            {
                return false;
            }
        }

        return true;
    }

    private static SurfacePoint Nearest(BodySkin skin, int first, Vector3 point)
    {
        (int Ring, int Segment) nearest = (first, 0);
        float least = float.MaxValue;
        for (int i = first; i <= Math.Min(first + Rings, BodyGrid.Rings - 2); i++)
        {
            for (int j = 0; j <= BodyGrid.Segments / 2; j++)
            {
                float squared = Vec.LengthSquared(skin[i, j] - point);
                if (squared < least)
                {
                    least = squared;
                    nearest = (i, j);
                }
            }
        }

        return skin.At(nearest.Ring, nearest.Segment);
    }
}
