using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>How fine an atlas must be for a picture: as fine as the picture itself where the creature faces the camera.</summary>
internal static class AtlasFineness
{
    // Fewer texels than pixels by this much are not seen: texels are filtered, and most of the skin is seen aslant.
    private const double MinTexelsPerPixel = 0.75;

    private const int Finest = 2048;

    /// <summary>Texels along the side of the smallest atlas that is fine enough.</summary>
    /// <param name="mesh">The creature's surface with its texture coordinates.</param>
    /// <param name="camera">From where it is seen.</param>
    /// <param name="height">Pixels of the picture from top to bottom.</param>
    public static int SizeFor(RenderMesh mesh, Camera camera, int height)
    {
        double pixelsPerMetre = camera.PixelsPerTangent(height) / Vec.Distance(camera.Eye, camera.Target);
        double wanted = MinTexelsPerPixel * pixelsPerMetre / SidesPerMetre(mesh);
        int size = CreatureTextures.SmallestSize;
        while (size < wanted && size < Finest)
        {
            size *= 2;
        }

        return size;
    }

    /// <summary>Part of the atlas's side that a metre of skin takes, in the mean over the surface.</summary>
    private static double SidesPerMetre(RenderMesh mesh)
    {
        double flat = 0;
        double real = 0;
        ReadOnlySpan<int> triangles = mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            Vector2 u = mesh.Texcoords[b] - mesh.Texcoords[a];
            Vector2 v = mesh.Texcoords[c] - mesh.Texcoords[a];
            double part = Math.Abs((u.X * v.Y) - (u.Y * v.X));
            if (part > 0)
            {
                flat += part;
                real += Vec.Cross(mesh.Positions[b] - mesh.Positions[a], mesh.Positions[c] - mesh.Positions[a]).Length();
            }
        }

        return real > 0 ? Math.Sqrt(flat / real) : 1;
    }
}
