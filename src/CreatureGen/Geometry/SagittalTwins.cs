using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Pairs the points of a surface that are exact mirror images of one another.</summary>
internal static class SagittalTwins
{
    /// <summary>For each point the one on the other side of the sagittal plane: itself on the plane, −1 when there is none.</summary>
    /// <param name="positions">Places of the points, no two the same.</param>
    public static int[] Find(Vector3[] positions)
    {
        int count = positions.Length;
        var both = new Vector3[2 * count];
        for (int p = 0; p < count; p++)
        {
            both[p] = positions[p];
            both[count + p] = Vec.Mirror(positions[p]);
        }

        int[] twin = new int[count];
        System.ReadOnlySpan<int> index = VertexWelding.Weld(both).NewIndex;
        for (int p = 0; p < count; p++)
        {
            twin[p] = index[count + p] < count ? index[count + p] : -1;
        }

        return twin;
    }
}
