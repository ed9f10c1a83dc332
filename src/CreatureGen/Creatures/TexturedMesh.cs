using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>A mesh made ready for its texture atlas: tangents for the normal map, and white where the atlas has the colour.</summary>
/// <remarks>
/// Left and right share their texels, so along back and belly the texture runs in opposite directions on the two sides: a vertex whose triangles disagree about that becomes two.
/// A tangent is the mean of the directions in which u grows over the triangles around a vertex, weighted by area in space, made perpendicular to the normal.
/// </remarks>
internal static class TexturedMesh
{
    /// <summary>Makes a mesh ready. The v of its texture coordinates points down the picture.</summary>
    public static CreatureMesh Of(CreatureMesh mesh)
    {
        int vertices = mesh.Positions.Length;
        int[] triangles = mesh.Triangles.ToArray();
        int[] mirroredCopy = new int[vertices];
        bool[] straight = new bool[vertices];
        for (int t = 0; t < triangles.Length; t += 3)
        {
            for (int c = t; c < t + 3 && !IsMirrored(mesh, triangles, t); c++)
            {
                straight[triangles[c]] = true;
            }
        }

        int count = vertices;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            bool mirrored = IsMirrored(mesh, triangles, t);
            for (int c = t; c < t + 3 && mirrored; c++)
            {
                int v = triangles[c];
                if (straight[v] && mirroredCopy[v] == 0)
                {
                    mirroredCopy[v] = count++;
                }
            }
        }

        CreatureMesh split = Split(mesh, triangles, mirroredCopy, count);
        return split.With(Directions(split));
    }

    private static CreatureMesh Split(CreatureMesh mesh, int[] triangles, int[] mirroredCopy, int count)
    {
        int[] source = new int[count];
        for (int v = 0; v < mirroredCopy.Length; v++)
        {
            source[v] = v;
            if (mirroredCopy[v] != 0)
            {
                source[mirroredCopy[v]] = v;
            }
        }

        for (int t = 0; t < triangles.Length; t += 3)
        {
            bool mirrored = IsMirrored(mesh, triangles, t);
            for (int c = t; c < t + 3 && mirrored; c++)
            {
                int copy = mirroredCopy[triangles[c]];
                triangles[c] = copy == 0 ? triangles[c] : copy;
            }
        }

        var positions = new Vector3[count];
        var normals = new Vector3[count];
        var texcoords = new Vector2[count];
        var colours = new Vector3[count];
        var weights = new SkinWeights[count];
        for (int v = 0; v < count; v++)
        {
            int from = source[v];
            positions[v] = mesh.Positions[from];
            normals[v] = mesh.Normals[from];
            texcoords[v] = mesh.Texcoords[from];
            colours[v] = CreatureTextures.KeepsItsColour(texcoords[v]) ? mesh.Colours[from] : Vector3.One;
            weights[v] = mesh.Weights[from];
        }

        return new CreatureMesh(positions, normals, texcoords, colours, weights, triangles, mesh.Parts);
    }

    private static Vector4[] Directions(CreatureMesh mesh)
    {
        ReadOnlySpan<int> triangles = mesh.Triangles;
        var sums = new Vector3[mesh.Positions.Length];
        float[] sides = new float[mesh.Positions.Length];
        for (int t = 0; t < triangles.Length; t += 3)
        {
            Vector3 p = mesh.Positions[triangles[t]];
            Vector3 e = mesh.Positions[triangles[t + 1]] - p;
            Vector3 f = mesh.Positions[triangles[t + 2]] - p;
            Vector2 uv = mesh.Texcoords[triangles[t]];
            Vector2 g = mesh.Texcoords[triangles[t + 1]] - uv;
            Vector2 h = mesh.Texcoords[triangles[t + 2]] - uv;
            float area = (g.X * h.Y) - (g.Y * h.X);
            Vector3 direction = Vec.Normalize(((e * h.Y) - (f * g.Y)) * (area < 0f ? -1f : 1f), Vector3.Zero) * Vec.Length(Vec.Cross(e, f));
            for (int c = t; c < t + 3; c++)
            {
                sums[triangles[c]] += direction;

                // v points down the picture and the third axis up it: where u × v points outwards, the axis is turned over.
                sides[triangles[c]] = area < 0f ? 1f : -1f;
            }
        }

        var tangents = new Vector4[sums.Length];
        for (int v = 0; v < tangents.Length; v++)
        {
            Vector3 n = mesh.Normals[v];
            Vector3 aside = Vec.Normalize(Vec.Cross(n, Math.Abs(n.Y) < 0.9f ? Vector3.UnitY : Vector3.UnitX), Vector3.UnitX);
            Vector3 tangent = Vec.Normalize(Vec.Reject(sums[v], n), aside);
            tangents[v] = new Vector4(tangent, sides[v] == 0f ? 1f : sides[v]);
        }

        return tangents;
    }

    /// <summary>Whether u × v points inwards on a triangle.</summary>
    private static bool IsMirrored(CreatureMesh mesh, int[] triangles, int t)
    {
        Vector2 uv = mesh.Texcoords[triangles[t]];
        Vector2 g = mesh.Texcoords[triangles[t + 1]] - uv;
        Vector2 h = mesh.Texcoords[triangles[t + 2]] - uv;
        return (g.X * h.Y) - (g.Y * h.X) < 0f;
    }
}
