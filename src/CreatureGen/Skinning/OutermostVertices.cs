using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Skinning;

/// <summary>The vertices of a skin that are farthest out, seen from each joint that moves them most: a few hundred stand for all where a body touches something.</summary>
internal static class OutermostVertices
{
    private static readonly Vector3[] directions = Directions();

    /// <summary>Finds them: for each joint the farthest vertex in each of 26 directions, the first of equally far ones; each vertex once, those of a joint beside each other.</summary>
    /// <param name="positions">At rest, one per vertex.</param>
    /// <param name="weights">One per vertex.</param>
    /// <param name="joints">Number of joints.</param>
    public static IReadOnlyList<int> Of(ReadOnlySpan<Vector3> positions, ReadOnlySpan<SkinWeights> weights, int joints)
    {
        float[] farthest = new float[joints * directions.Length];
        int[] vertices = new int[farthest.Length];
        Array.Fill(vertices, -1);
        for (int v = 0; v < positions.Length; v++)
        {
            int first = weights[v].Joint0 * directions.Length;
            for (int d = 0; d < directions.Length; d++)
            {
                float along = Vec.Dot(positions[v], directions[d]);
                if (vertices[first + d] < 0 || along > farthest[first + d])
                {
                    vertices[first + d] = v;
                    farthest[first + d] = along;
                }
            }
        }

        var found = new List<int>();
        var known = new HashSet<int>();
        foreach (int v in vertices)
        {
            if (v >= 0 && known.Add(v))
            {
                found.Add(v);
            }
        }

        return found;
    }

    private static Vector3[] Directions()
    {
        var all = new List<Vector3>();
        for (int x = -1; x <= 1; x++)
        {
            for (int y = -1; y <= 1; y++)
            {
                for (int z = -1; z <= 1; z++)
                {
                    var direction = new Vector3(x, y, z);
                    if (direction != Vector3.Zero)
                    {
                        all.Add(Vec.Normalize(direction));
                    }
                }
            }
        }

        return all.ToArray();
    }
}
