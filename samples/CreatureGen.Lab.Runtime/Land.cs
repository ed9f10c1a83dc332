using System;
using System.Numerics;
using CreatureGen.Motion;

namespace CreatureGen.Lab.Runtime;

/// <summary>The ground of the stage.</summary>
internal sealed class Land
{
    public static readonly Land Plane = new(FlatGround.Level, 40f, float.PositiveInfinity);

    public Land(ReadOnlySpan<float> heights, int columns, float cell, float corner, float surface)
        : this(new HeightFieldGround(heights, columns, cell, new Vector3(corner, 0f, corner)), 0.5f * (columns - 1) * cell, surface)
    {
    }

    private Land(IGround ground, float halfWidth, float surface)
    {
        Ground = ground;
        HalfWidth = halfWidth;
        Surface = surface;
    }

    public IGround Ground { get; }

    /// <summary>Metres from the middle to the edge.</summary>
    public float HalfWidth { get; }

    /// <summary>Height of the water's surface, metres; infinite in the sea, whose surface nobody reaches.</summary>
    public float Surface { get; }

    /// <summary>Height of the ground at a place; 0 beyond its edges.</summary>
    public float HeightAt(float x, float z) => Ground.Cast(new Vector3(x, 1e4f, z), -Vector3.UnitY, 2e4f, out GroundHit hit) ? hit.Point.Y : 0f;
}
