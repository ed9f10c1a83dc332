using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Pairs the points of a surface that are exact mirror images of one another.</summary>
internal static class SagittalTwins
{
    /// <summary>For each point the one on the other side of the sagittal plane: itself on the plane, −1 when there is none.</summary>
    /// <param name="points">The points, no two in the same place.</param>
    public static int[] Find(VertexWelding points)
    {
        int[] twin = new int[points.Positions.Length];
        for (int p = 0; p < twin.Length; p++)
        {
            twin[p] = points.IndexAt(Vec.Mirror(points.Positions[p]));
        }

        return twin;
    }
}
