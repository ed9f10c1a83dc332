using CreatureGen.Json;
using CreatureGen.Maths;
using static CreatureGen.Blueprints.CommonRanges;

namespace CreatureGen.Blueprints;

/// <summary>The fields of hair and of collars.</summary>
internal static class NeckFields
{
    private static readonly NumberRange quarterTurn = new(0, 1.5);
    private static readonly NumberRange halfTurn = new(0, PortableMath.Pi);

    /// <summary>A mane.</summary>
    public static readonly RecordDescription<ManeBlueprint> Mane = new(
        new ManeBlueprint(Ring: 16, LastRing: 24, Segment: 0, LastSegment: 8, Rows: 4, Columns: 4, Length: 0.15, Growth: 1, Width: 0.03, Rise: 0.4, Fall: 0.5, Hang: 0),
        JsonLayout.Indented,
        (visit, mane) => new ManeBlueprint(
            visit.Number("ring", mane.Ring, Ring),
            visit.Number("lastRing", mane.LastRing, Ring),
            visit.Number("segment", mane.Segment, Segment),
            visit.Number("lastSegment", mane.LastSegment, Segment),
            visit.Whole("rows", mane.Rows, new WholeRange(1, 24)),
            visit.Whole("columns", mane.Columns, new WholeRange(1, 16)),
            visit.Number("length", mane.Length, new NumberRange(0.005, 2)),
            visit.Number("growth", mane.Growth, new NumberRange(0.2, 5)),
            visit.Number("width", mane.Width, new NumberRange(0.002, 0.5)),
            visit.Number("rise", mane.Rise, quarterTurn),
            visit.Number("fall", mane.Fall, halfTurn),
            visit.Number("hang", mane.Hang, Fraction)));

    /// <summary>A frill.</summary>
    public static readonly RecordDescription<FrillBlueprint> Frill = new(
        new FrillBlueprint(Ring: 14, Spread: 9, Length: 0.3, Tilt: 0.7, Bend: 0, Thickness: 0.02, Points: 6, Scallop: 0.1),
        JsonLayout.Indented,
        (visit, frill) => new FrillBlueprint(
            visit.Number("ring", frill.Ring, Ring),
            visit.Number("spread", frill.Spread, new NumberRange(2, 15.5)),
            visit.Number("length", frill.Length, new NumberRange(0.01, 3)),
            visit.Number("tilt", frill.Tilt, quarterTurn),
            visit.Number("bend", frill.Bend, new NumberRange(-1, 1)),
            visit.Number("thickness", frill.Thickness, new NumberRange(0.002, 0.5)),
            visit.Whole("points", frill.Points, new WholeRange(2, 12)),
            visit.Number("scallop", frill.Scallop, new NumberRange(0, 0.6))));

    /// <summary>A fork.</summary>
    public static readonly RecordDescription<ForkBlueprint> Fork = new(
        new ForkBlueprint(Ring: 22, Spread: 0.6, Length: 1, Size: 0.85),
        JsonLayout.Indented,
        (visit, fork) => new ForkBlueprint(
            visit.Whole("ring", fork.Ring, new WholeRange(20, 26)),
            visit.Number("spread", fork.Spread, new NumberRange(0.1, 1.2)),
            visit.Number("length", fork.Length, new NumberRange(0.5, 2)),
            visit.Number("size", fork.Size, new NumberRange(0.4, 1))));
}
