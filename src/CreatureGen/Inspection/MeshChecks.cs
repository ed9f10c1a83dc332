using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Inspection;

/// <summary>Whether the buffers hold numbers, the surface is closed and whole, and its sides are mirror images.</summary>
internal static class MeshChecks
{
    /// <summary>How far a normal may be from unit length.</summary>
    private const float NormalLength = 1e-3f;

    /// <summary>How far the mass may be from that of the mesh, which has lost a little of its volume when it was thinned out to fit its budget.</summary>
    private const double VolumeFraction = 0.02;

    /// <summary>
    /// What flat facets cut off a round body shrinks as their number grows: a sphere loses about 11 / n of its volume to n triangles inscribed in it, a body with limbs and wings, of which hair and feathers
    /// take most of a small budget, up to 82 / n (750 seeds at 6,000 triangles; a few edited creatures 75). The mass stays that of the whole creature: it weighs the same at every budget.
    /// </summary>
    private const double FacetLoss = 110;

    /// <summary>False when a number of the mesh is not finite: nothing else can be measured then.</summary>
    public static bool AreFinite(CreatureMesh mesh, ViolationList found)
    {
        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            Vector3 p = mesh.Positions[v], n = mesh.Normals[v], c = mesh.Colours[v];
            Vector2 t = mesh.Texcoords[v];
            float sum = p.X + p.Y + p.Z + n.X + n.Y + n.Z + c.X + c.Y + c.Z + t.X + t.Y;
            if (!float.IsFinite(sum) || !IsUnit(n) || !InRange(c))
            {
                found.Add(CreatureInspection.Finite, $"vertex {v} has position {p}, normal {n}, colour {c}, texture coordinates {t}; expected finite numbers, a unit normal and a colour of 0..1");
                return false;
            }
        }

        return true;
    }

    /// <summary>Checks the surface.</summary>
    public static void Check(Creature creature, WeldedSkin skin, ViolationList found)
    {
        SurfaceTopology all = SurfaceTopology.Of(skin.Positions, skin.OpaqueTriangles);
        if (!all.IsClosed || all.DuplicateTriangles > 0)
        {
            found.Add(
                CreatureInspection.Closed,
                $"{all.OpenEdges} open edges, {all.NonManifoldEdges} edges of three or more triangles, {all.WindingEdges} edges wound against each other, {all.PinchedVertices} pinched vertices, {all.DuplicateTriangles} duplicate triangles; expected none");
        }

        // Of a closed surface each edge has two of the triangles' three edges.
        int euler = all.IsClosed ? skin.BodyVertices - (skin.BodyTriangles.Length / 6) : SurfaceTopology.Of(skin.Positions, skin.BodyTriangles).EulerCharacteristic;
        if (euler != 2)
        {
            found.Add(CreatureInspection.OneSurface, $"body and limbs have Euler characteristic {euler}; expected 2, one surface without handles");
        }

        double volume = VolumeOf(skin);
        double fraction = Math.Max(VolumeFraction, FacetLoss * 3 / skin.BodyTriangles.Length);
        if (!(volume > 0) || Math.Abs(volume - creature.Mass.Volume) > fraction * volume)
        {
            found.Add(CreatureInspection.PositiveVolume, $"body and limbs enclose {volume} m³ and the creature says {creature.Mass.Volume} m³; expected the same volume above zero");
        }

        if (all.DegenerateTriangles > 0)
        {
            found.Add(CreatureInspection.Degenerate, $"{all.DegenerateTriangles} triangles have no area; expected none");
        }

        CheckMirror(skin, found);
        int triangles = creature.Mesh.Triangles.Length / 3;
        if (triangles > creature.Blueprint.TriangleBudget)
        {
            found.Add(CreatureInspection.Budget, $"{triangles} triangles; expected at most {creature.Blueprint.TriangleBudget}");
        }
    }

    private static double VolumeOf(WeldedSkin skin)
    {
        double six = 0;
        ReadOnlySpan<int> t = skin.BodyTriangles;
        for (int i = 0; i < t.Length; i += 3)
        {
            Vector3 a = skin.Positions[t[i]], b = skin.Positions[t[i + 1]], c = skin.Positions[t[i + 2]];
            six += (a.X * (((double)b.Y * c.Z) - ((double)b.Z * c.Y))) - (a.Y * (((double)b.X * c.Z) - ((double)b.Z * c.X))) + (a.Z * (((double)b.X * c.Y) - ((double)b.Y * c.X)));
        }

        return six / 6;
    }

    private static void CheckMirror(WeldedSkin skin, ViolationList found)
    {
        foreach (Vector3 place in skin.Positions)
        {
            if (!skin.HasVertexAt(Vec.Mirror(place)))
            {
                found.Add(CreatureInspection.Mirrored, $"the vertex at {place} has no mirror image; expected one at exactly {Vec.Mirror(place)}");
                return;
            }
        }
    }

    private static bool IsUnit(Vector3 n) => Math.Abs(Vec.Length(n) - 1f) <= NormalLength;

    private static bool InRange(Vector3 c) => Math.Min(c.X, Math.Min(c.Y, c.Z)) >= 0f && Math.Max(c.X, Math.Max(c.Y, c.Z)) <= 1f;
}
