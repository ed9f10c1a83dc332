using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Tests.Motion;

/// <summary>A flier as seen from its left: what of its skin is in front at each place, counted naively.</summary>
internal static class SideView
{
    private const int Columns = 70;

    private enum Kind
    {
        Wing,
        Trunk,
        Other,
    }

    /// <summary>Share of the places where there is a left wing at which trunk or tail are in front of it.</summary>
    public static double BodyThroughWing(StandingFlier flier)
    {
        Kind[] kinds = Enumerable.Range(0, flier.Skin.Length).Select(v => KindOf(flier, v)).ToArray();
        Vector3[] wing = Enumerable.Range(0, kinds.Length).Where(v => kinds[v] == Kind.Wing && flier.Skin[v].X > 0f).Select(v => flier.Skin[v]).ToArray();
        float cell = (wing.Max(p => p.Z) - wing.Min(p => p.Z)) / Columns;
        var places = new Dictionary<(int Row, int Column), (float Body, float Wing)>();
        ReadOnlySpan<int> triangles = flier.Creature.Mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            int[] corners = triangles.Slice(t, 3).ToArray();
            if (corners.Any(v => kinds[v] != kinds[corners[0]]) || kinds[corners[0]] == Kind.Other)
            {
                continue;
            }

            foreach ((int row, int column, float x) in Places(corners.Select(v => flier.Skin[v] / cell).ToArray()))
            {
                (float body, float ofWing) = places.TryGetValue((row, column), out (float, float) found) ? found : (0f, 0f);
                places[(row, column)] = kinds[corners[0]] == Kind.Wing ? (body, Math.Max(ofWing, x)) : (Math.Max(body, x), ofWing);
            }
        }

        (float Body, float Wing)[] winged = places.Values.Where(place => place.Wing > 0f).ToArray();
        return (double)winged.Count(place => place.Body > place.Wing) / winged.Length;
    }

    /// <summary>The middles of cells of one unit that a triangle covers, and how far out it is there.</summary>
    private static IEnumerable<(int Row, int Column, float X)> Places(Vector3[] p)
    {
        float area = ((p[1].Y - p[2].Y) * (p[0].Z - p[2].Z)) + ((p[2].Z - p[1].Z) * (p[0].Y - p[2].Y));
        for (int row = (int)Math.Floor(p.Min(c => c.Y)); area != 0f && row <= p.Max(c => c.Y); row++)
        {
            for (int column = (int)Math.Floor(p.Min(c => c.Z)); column <= p.Max(c => c.Z); column++)
            {
                float y = row + 0.5f - p[2].Y;
                float z = column + 0.5f - p[2].Z;
                float first = (((p[1].Y - p[2].Y) * z) + ((p[2].Z - p[1].Z) * y)) / area;
                float second = (((p[2].Y - p[0].Y) * z) + ((p[0].Z - p[2].Z) * y)) / area;
                float x = (p[0].X * first) + (p[1].X * second) + (p[2].X * (1f - first - second));
                if (first >= 0f && second >= 0f && first + second <= 1f && x > 0f)
                {
                    yield return (row, column, x);
                }
            }
        }
    }

    private static Kind KindOf(StandingFlier flier, int vertex)
    {
        SkinWeights weights = flier.Creature.Mesh.Weights[vertex];
        Span<(int Joint, float Fraction)> influences =
        [
            (weights.Joint0, weights.Weights.X), (weights.Joint1, weights.Weights.Y), (weights.Joint2, weights.Weights.Z), (weights.Joint3, weights.Weights.W),
        ];
        float wing = 0f;
        float trunk = 0f;
        foreach ((int joint, float fraction) in influences)
        {
            JointRole role = flier.Creature.Skeleton.Joints[joint].Role;
            wing += role == JointRole.Wing ? fraction : 0f;
            trunk += role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Tail ? fraction : 0f;
        }

        return wing > 0.5f ? Kind.Wing : trunk > 0.98f ? Kind.Trunk : Kind.Other;
    }
}
