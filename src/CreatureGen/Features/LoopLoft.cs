using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A closed shell over a row of closed loops, all of the same number of points, from one pole to another.</summary>
internal static class LoopLoft
{
    /// <summary>
    /// Joins loops that are the builder's last vertices, loop after loop, to each other and to a pole at either end, and gives all of them their normals.
    /// </summary>
    /// <param name="builder">Holds the loops; gets poles and triangles.</param>
    /// <param name="first">The first vertex of the first loop.</param>
    /// <param name="sides">Vertices per loop, at least 3; seen from the far end of the row they run counter-clockwise.</param>
    /// <param name="start">The pole before the first loop.</param>
    /// <param name="startColour">Linear RGB there.</param>
    /// <param name="end">The pole behind the last loop.</param>
    /// <param name="endColour">Linear RGB there.</param>
    /// <param name="middle">The vertex of a loop about which it is its own mirror image, so that its triangles are too; −1 where it is not.</param>
    public static void Close(PieceBuilder builder, int first, int sides, Vector3 start, Vector3 startColour, Vector3 end, Vector3 endColour, int middle = -1)
    {
        int loops = (builder.VertexCount - first) / sides;
        for (int i = 0; i < loops; i++)
        {
            int loop = first + (i * sides);
            for (int k = 0; k < sides; k++)
            {
                // Central differences: exact mirror images get exactly mirrored normals, whatever the diagonals of the quads.
                Vector3 around = builder.Position(loop + ((k + 1) % sides)) - builder.Position(loop + ((k + sides - 1) % sides));
                Vector3 behind = i > 0 ? builder.Position(loop - sides + k) : start;
                Vector3 ahead = i + 1 < loops ? builder.Position(loop + sides + k) : end;
                Vector3 normal = Vec.Cross(around / Math.Max(Vec.Length(around), 1e-9f), (ahead - behind) / Math.Max(Vec.Length(ahead - behind), 1e-9f));
                builder.SetNormal(loop + k, Vec.Normalize(normal, Vector3.UnitY));
            }

            if (i > 0)
            {
                Join(builder, loop - sides, loop, sides, middle);
            }
        }

        int last = first + ((loops - 1) * sides);
        Vector3 axis = Vec.Normalize(end - start, Vector3.UnitY);
        int startPole = builder.Vertex(start, Vector3.Zero - axis, startColour);
        int endPole = builder.Vertex(end, axis, endColour);
        builder.FanBelow(first, startPole, sides);
        builder.Fan(last, endPole, sides);
    }

    private static void Join(PieceBuilder builder, int loop, int next, int sides, int middle)
    {
        if (middle < 0)
        {
            builder.Band(loop, next, sides);
            return;
        }

        for (int k = 0; k < sides; k++)
        {
            int k2 = (k + 1) % sides;
            if ((k + sides - middle) % sides < sides / 2)
            {
                builder.Quad(loop + k, loop + k2, next + k2, next + k);
            }
            else
            {
                builder.Quad(loop + k2, next + k2, next + k, loop + k);
            }
        }
    }
}
