using System;

namespace CreatureGen.Anatomy;

/// <summary>
/// The one grid that every body is bent from: rings along the body and segments around it.
/// </summary>
/// <remarks>
/// Ring 0 is the nose, ring 54 the tip of the tail; those that have a name are in <see cref="StationRing"/>. Segment 0 is dorsal, 8 the left flank (+X), 16 ventral, 24 the right flank; segment j mirrors to (32 − j) mod 32.
/// A cell (ring i, segment j) is the quad between rings i and i + 1 and segments j and j + 1. The same ring means the same anatomy in every body.
/// </remarks>
internal static class BodyGrid
{
    /// <summary>Number of rings, nose to tail.</summary>
    public const int Rings = StationRing.TailTip + 1;

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

    private static readonly int[] stationRings =
    {
        StationRing.Nose, StationRing.MuzzleFront, StationRing.MuzzleMiddle, StationRing.Stop, StationRing.Brow, StationRing.Cranium, StationRing.Nape,
        StationRing.NeckMiddle, StationRing.NeckBase, StationRing.Shoulder, StationRing.Ribs, StationRing.Belly, StationRing.Loin, StationRing.Pelvis,
        StationRing.TailBase, StationRing.TailThird, StationRing.TailTwoThirds, StationRing.TailTip,
    };

    /// <summary>The ring of each station, nose to tail.</summary>
    public static ReadOnlySpan<int> StationRings => stationRings;

    /// <summary>The segment on the other side of the body.</summary>
    public static int MirrorSegment(int segment) => (Segments - segment) % Segments;

    /// <summary>The cell column on the other side of the body.</summary>
    public static int MirrorCell(int column) => Segments - 1 - column;
}
