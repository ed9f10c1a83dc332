using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;

namespace CreatureGen.Tests.Appearance;

/// <summary>What of the outline of a head is seen from ahead: a small picture of the mesh, in which each point knows whether it is head, body or neither.</summary>
internal static class HeadOutline
{
    private const int Size = 160;

    /// <summary>How far from the outline colours are compared, points.</summary>
    private const int Aside = 3;

    /// <summary>Least distance of two colours, as OKLAB has it, that are told from each other.</summary>
    private const float Told = 0.08f;

    // How high over the horizon the eye is, as on sheets.
    private const float Sine = 0.1736f;
    private const float Cosine = 0.9848f;

    private enum Part : byte
    {
        Nothing,
        Body,
        Head,
    }

    /// <summary>The share of a head's outline that is against the background, or against a body of another colour.</summary>
    public static double Seen(Creature creature)
    {
        bool[] head = creature.Skeleton.Joints.Select(joint => joint.Name is "Head" or "Jaw" || joint.Name.StartsWith("Eye", StringComparison.Ordinal) || joint.Name.Contains("Lid", StringComparison.Ordinal) || joint.Name.StartsWith("Ear", StringComparison.Ordinal)).ToArray();
        (Part[] parts, Vector3[] colours) = Picture(creature.Mesh, head);
        int edge = 0;
        int seen = 0;
        foreach (int step in new[] { 1, -1, Size, -Size })
        {
            for (int at = Aside * (Size + 1); at < parts.Length - (Aside * (Size + 1)); at++)
            {
                if (parts[at] != Part.Head || parts[at + step] == Part.Head)
                {
                    continue;
                }

                int outside = parts[at + (Aside * step)] == Part.Body ? at + (Aside * step) : at + step;
                int inside = parts[at - (Aside * step)] == Part.Head ? at - (Aside * step) : at;
                edge++;
                seen += parts[at + step] == Part.Nothing || Vector3.Distance(Lab(colours[outside]), Lab(colours[inside])) > Told ? 1 : 0;
            }
        }

        return seen / (double)Math.Max(1, edge);
    }

    private static (Part[] Parts, Vector3[] Colours) Picture(CreatureMesh mesh, bool[] head)
    {
        ReadOnlySpan<Vector3> positions = mesh.Positions;
        var seen = new Vector3[positions.Length];
        var isHead = new bool[positions.Length];
        var min = new Vector2(float.MaxValue);
        var max = new Vector2(float.MinValue);
        for (int v = 0; v < seen.Length; v++)
        {
            Vector3 p = positions[v];
            seen[v] = new Vector3(-p.X, (Cosine * p.Y) - (Sine * p.Z), (Sine * p.Y) + (Cosine * p.Z));
            isHead[v] = head[mesh.Weights[v].Joint0];
            min = isHead[v] ? Vector2.Min(min, new Vector2(seen[v].X, seen[v].Y)) : min;
            max = isHead[v] ? Vector2.Max(max, new Vector2(seen[v].X, seen[v].Y)) : max;
        }

        float scale = Size / (1.3f * Math.Max(max.X - min.X, max.Y - min.Y));
        var corner = new Vector3((0.5f * (min + max)) - new Vector2(0.5f * Size / scale), 0f);
        var parts = new Part[Size * Size];
        var colours = new Vector3[Size * Size];
        var depths = Enumerable.Repeat(float.MinValue, Size * Size).ToArray();
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            (int a, int b, int c) = (mesh.Triangles[t], mesh.Triangles[t + 1], mesh.Triangles[t + 2]);
            Vector3 pa = (seen[a] - corner) * scale;
            Vector3 pb = (seen[b] - corner) * scale;
            Vector3 pc = (seen[c] - corner) * scale;
            float area = ((pb.X - pa.X) * (pc.Y - pa.Y)) - ((pb.Y - pa.Y) * (pc.X - pa.X));
            for (int y = First(pa.Y, pb.Y, pc.Y); y <= Last(pa.Y, pb.Y, pc.Y) && area != 0f; y++)
            {
                for (int x = First(pa.X, pb.X, pc.X); x <= Last(pa.X, pb.X, pc.X); x++)
                {
                    float wb = (((x - pa.X) * (pc.Y - pa.Y)) - ((y - pa.Y) * (pc.X - pa.X))) / area;
                    float wc = (((pb.X - pa.X) * (y - pa.Y)) - ((pb.Y - pa.Y) * (x - pa.X))) / area;
                    float wa = 1f - wb - wc;
                    float depth = (wa * pa.Z) + (wb * pb.Z) + (wc * pc.Z);
                    int at = (y * Size) + x;
                    if (wa >= 0f && wb >= 0f && wc >= 0f && depth > depths[at])
                    {
                        depths[at] = depth;
                        parts[at] = isHead[a] && isHead[b] && isHead[c] ? Part.Head : Part.Body;
                        colours[at] = (wa * mesh.Colours[a]) + (wb * mesh.Colours[b]) + (wc * mesh.Colours[c]);
                    }
                }
            }
        }

        return (parts, colours);

        static int First(float a, float b, float c) => Math.Max(0, (int)MathF.Ceiling(Math.Min(a, Math.Min(b, c))));

        static int Last(float a, float b, float c) => Math.Min(Size - 1, (int)MathF.Floor(Math.Max(a, Math.Max(b, c))));
    }

    /// <summary>OKLAB of linear RGB.</summary>
    private static Vector3 Lab(Vector3 c)
    {
        float l = MathF.Cbrt((0.4122f * c.X) + (0.5363f * c.Y) + (0.0514f * c.Z));
        float m = MathF.Cbrt((0.2119f * c.X) + (0.6807f * c.Y) + (0.1074f * c.Z));
        float s = MathF.Cbrt((0.0883f * c.X) + (0.2817f * c.Y) + (0.6300f * c.Z));
        return new Vector3((0.2105f * l) + (0.7936f * m) - (0.0041f * s), (1.9780f * l) - (2.4286f * m) + (0.4506f * s), (0.0259f * l) + (0.7828f * m) - (0.8087f * s));
    }
}
