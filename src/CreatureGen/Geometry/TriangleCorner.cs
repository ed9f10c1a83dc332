namespace CreatureGen.Geometry;

/// <summary>Corners of triangles by number: three follow one another for each triangle.</summary>
/// <remarks>They are never negative; saying so saves the corrections that a signed quotient takes.</remarks>
internal static class TriangleCorner
{
    /// <summary>The triangle of a corner.</summary>
    public static int TriangleOf(int corner) => (int)((uint)corner / 3u);

    /// <summary>The corner after another one of the same triangle.</summary>
    public static int Next(int corner) => (uint)corner % 3u == 2u ? corner - 2 : corner + 1;

    /// <summary>The corner before another one of the same triangle.</summary>
    public static int Previous(int corner) => (uint)corner % 3u == 0u ? corner + 2 : corner - 1;
}
