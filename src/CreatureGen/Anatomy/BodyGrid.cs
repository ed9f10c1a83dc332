using System;

namespace CreatureGen.Anatomy;

/// <summary>
/// The one grid that every body is bent from: rings along the body and segments around it.
/// </summary>
/// <remarks>
/// Ring 0 is the nose, ring 54 the tip of the tail. Segment 0 is dorsal, 8 the left flank (+X), 16 ventral, 24 the right flank; segment j mirrors to (32 − j) mod 32.
/// A cell (ring i, segment j) is the quad between rings i and i + 1 and segments j and j + 1. The same ring means the same anatomy in every body.
/// </remarks>
internal static class BodyGrid
{
    /// <summary>Number of rings, nose to tail.</summary>
    public const int Rings = 55;

    /// <summary>Number of segments around a ring.</summary>
    public const int Segments = 32;

    /// <summary>Number of stations at which body tables give numbers.</summary>
    public const int StationCount = 18;

    /// <summary>The ring that keeps its own pitch when spines are bent, and the origin that spines are integrated from.</summary>
    public const int AnchorRing = 32;

    /// <summary>The segment of the left flank along which the mouth is slit.</summary>
    public const int LipSegment = 10;

    /// <summary>Number of bones that the bend of a neck is spread over.</summary>
    public const int NeckBones = 3;

    /// <summary>Number of bones that the bend of a tail is spread over.</summary>
    public const int TailBones = 6;

    private static readonly int[] stationRings = { 0, 2, 4, 7, 10, 13, 16, 19, 22, 26, 30, 34, 38, 42, 45, 48, 51, 54 };

    /// <summary>The ring of each station: nose, muzzle front, muzzle middle, stop, brow, cranium, nape, neck middle, neck base, shoulder, ribs, belly, loin, pelvis, tail base, tail third, tail two thirds, tail tip.</summary>
    public static ReadOnlySpan<int> StationRings => stationRings;

    /// <summary>The segment on the other side of the body.</summary>
    public static int MirrorSegment(int segment) => (Segments - segment) % Segments;

    /// <summary>The cell column on the other side of the body.</summary>
    public static int MirrorCell(int column) => Segments - 1 - column;
}
