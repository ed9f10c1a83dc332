using System.Numerics;
using System;
using CreatureGen.Creatures;
using CreatureGen.Skinning;

namespace CreatureGen.Gltf;

/// <summary>Takes a mesh apart into triangles that share no vertex, each with the normal of its plane.</summary>
internal static class FlatShading
{
    /// <summary>The facets of a mesh: vertex i of the result is corner i of the triangles.</summary>
    /// <exception cref="InvalidOperationException">A triangle has no area, and so no normal.</exception>
    public static CreatureMesh Split(CreatureMesh mesh)
    {
        ReadOnlySpan<int> corners = mesh.Triangles;
        var positions = new Vector3[corners.Length];
        var normals = new Vector3[corners.Length];
        var texcoords = new Vector2[corners.Length];
        var colours = new Vector3[corners.Length];
        var weights = new SkinWeights[corners.Length];
        var triangles = new int[corners.Length];
        for (int i = 0; i < corners.Length; i++)
        {
            int vertex = corners[i];
            positions[i] = mesh.Positions[vertex];
            texcoords[i] = mesh.Texcoords[vertex];
            colours[i] = mesh.Colours[vertex];
            weights[i] = mesh.Weights[vertex];
            triangles[i] = i;
        }

        for (int i = 0; i < corners.Length; i += 3)
        {
            Vector3 normal = Normal(positions[i], positions[i + 1], positions[i + 2], i / 3);
            normals[i] = normal;
            normals[i + 1] = normal;
            normals[i + 2] = normal;
        }

        return new CreatureMesh(positions, normals, texcoords, colours, weights, triangles, mesh.Parts);
    }

    private static Vector3 Normal(Vector3 a, Vector3 b, Vector3 c, int triangle)
    {
        double ux = (double)b.X - a.X;
        double uy = (double)b.Y - a.Y;
        double uz = (double)b.Z - a.Z;
        double vx = (double)c.X - a.X;
        double vy = (double)c.Y - a.Y;
        double vz = (double)c.Z - a.Z;
        double x = (uy * vz) - (uz * vy);
        double y = (uz * vx) - (ux * vz);
        double z = (ux * vy) - (uy * vx);
        double length = Math.Sqrt((x * x) + (y * y) + (z * z));
        if (!(length > 0))
        {
            throw ExportError.At(
                FormattableString.Invariant($"triangle {triangle}"),
                "it has no area, its corners are " + ExportError.Text(a) + ", " + ExportError.Text(b) + ", " + ExportError.Text(c),
                "a plane, whose normal flat shading needs");
        }

        return new Vector3((float)(x / length), (float)(y / length), (float)(z / length));
    }
}
