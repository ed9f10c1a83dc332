using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>What furred tails wear, as data: lengths and widths in lengths of the tail. Numbers were tuned by eye from the side and behind.</summary>
internal static class TailHair
{
    /// <summary>A tassel at the end of a bare tail (cattle, lion).</summary>
    public static readonly ManePreset Tuft = new(
        0.85,
        1.2,
        new ManeBlueprint(Ring: 50.5, LastRing: 53, Segment: 0, LastSegment: 16, Rows: 3, Columns: 5, Length: 0.24, Growth: 0.9, Width: 0.027, Rise: 0.22, Fall: 0, Hang: 0.1));

    /// <summary>Long hair from the root on (horse).</summary>
    public static readonly ManePreset Skirt = new(
        0.85,
        1.2,
        new ManeBlueprint(Ring: 45.2, LastRing: 52.5, Segment: 0, LastSegment: 16, Rows: 7, Columns: 5, Length: 0.58, Growth: 0.9, Width: 0.055, Rise: 0.14, Fall: 0, Hang: 0.2));

    /// <summary>Thick hair all along, which ends in a point (dog, fox).</summary>
    public static readonly ManePreset Brush = new(
        0.85,
        1.25,
        new ManeBlueprint(Ring: 46, LastRing: 53, Segment: 0, LastSegment: 16, Rows: 7, Columns: 5, Length: 0.32, Growth: 0.85, Width: 0.04, Rise: 0.3, Fall: 0, Hang: 0.15));

    /// <summary>A tail that is hardly more than hair (rabbit, bear).</summary>
    public static readonly ManePreset Scut = new(
        0.85,
        1.15,
        new ManeBlueprint(Ring: 45, LastRing: 53, Segment: 0, LastSegment: 16, Rows: 5, Columns: 6, Length: 0.64, Growth: 0.8, Width: 0.08, Rise: 0.5, Fall: 0, Hang: 0.15));
}
