using System;
using CreatureGen.Anatomy;
using CreatureGen.Geometry;

namespace CreatureGen.Limbs;

/// <summary>Takes what crossings the rules of growth have left out of a welded surface: lips and mouth stay as they are, soles stay on the ground.</summary>
internal static class SurfaceUntangler
{
    [ThreadStatic]
    private static CrossingPairs? crossings;

    /// <summary>Moves the points of the surface in place, where triangles cross and only there; left and right stay exact mirror images.</summary>
    public static void Untangle(Surface surface)
    {
        bool[] held = new bool[surface.Positions.Length];
        bool[] grounded = new bool[surface.Positions.Length];
        for (int v = 0; v < held.Length; v++)
        {
            held[v] = surface.Addresses[v].Region is SurfaceRegion.Mouth or SurfaceRegion.Lip;
            grounded[v] = surface.Positions[v].Y == 0f;
        }

        Untangling.Repair(surface.Positions, surface.Triangles, surface.Mirror, held, grounded, crossings ??= new CrossingPairs());
    }
}
