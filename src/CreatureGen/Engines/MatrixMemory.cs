namespace CreatureGen.Engines;

/// <summary>In which order the 16 numbers of a matrix follow one another in memory.</summary>
public enum MatrixMemory
{
    /// <summary>
    /// Where the x axis goes to, then the y axis, the z axis and the origin, four numbers each. This is a matrix for row vectors stored row by row (<c>System.Numerics</c>, MonoGame, Unreal)
    /// and just as well one for column vectors stored column by column (Unity, OpenGL).
    /// </summary>
    AxisByAxis,

    /// <summary>The other way round: the x of all four, then y, z and w (Stride).</summary>
    Transposed,
}
