using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;
using static CreatureGen.Blueprints.CommonRanges;

namespace CreatureGen.Blueprints;

/// <summary>The fields of all that grows out of the body or sits on it.</summary>
internal static class LimbFields
{
    private static readonly NumberRange span = new(0.02, 10);

    /// <summary>Where a limb grows.</summary>
    public static readonly RecordDescription<SocketBlueprint> Socket = new(
        new SocketBlueprint(Ring: 26, Segment: 8, Rows: 4, Columns: 4),
        JsonLayout.Line,
        (visit, socket) => new SocketBlueprint(
            visit.Whole("ring", socket.Ring, new WholeRange(1, BodyGrid.Rings - 3)),
            visit.Whole("segment", socket.Segment, new WholeRange(0, BodyGrid.Segments - 1)),
            visit.Whole("rows", socket.Rows, WholeRange.Even(2, 22)),
            visit.Whole("columns", socket.Columns, WholeRange.Even(2, 16))));

    /// <summary>A pair of legs or arms.</summary>
    public static readonly RecordDescription<LegBlueprint> Leg = new(
        new LegBlueprint(LimbArchetype.PlantigradeHind, LegStance.Standing, Socket.Neutral, Thickness: 0.1, Length: 0.5, Reach: 0.5, Azimuth: 0, Shear: 0, Slimness: 1, Stoutness: 1, FootSize: 1, KneeRise: 1, Toes: 3, ClawLength: 0),
        JsonLayout.Indented,
        (visit, leg) => new LegBlueprint(
            visit.Choice("archetype", leg.Archetype, AnatomyChoices.Archetype),
            visit.Choice("stance", leg.Stance, AnatomyChoices.Stance),
            visit.Record("socket", leg.Socket, Socket),
            visit.Number("thickness", leg.Thickness, new NumberRange(0.005, 1)),
            visit.Number("length", leg.Length, new NumberRange(0.01, 10)),
            visit.Number("reach", leg.Reach, new NumberRange(0.01, 10)),
            visit.Number("azimuth", leg.Azimuth, Angle),
            visit.Number("shear", leg.Shear, new NumberRange(-2, 2)),
            visit.Number("slimness", leg.Slimness, Factor),
            visit.Number("stoutness", leg.Stoutness, Factor),
            visit.Number("footSize", leg.FootSize, Factor),
            visit.Number("kneeRise", leg.KneeRise, new NumberRange(0, 4)),
            visit.Whole("toes", leg.Toes, new WholeRange(1, 8)),
            visit.Number("clawLength", leg.ClawLength, new NumberRange(0, 6)),
            visit.Since(5).Choice("foot", leg.Foot, AnatomyChoices.Foot)));

    /// <summary>A pair of stitched wings.</summary>
    public static readonly RecordDescription<WingBlueprint> Wing = new(
        new WingBlueprint(WingStyle.Bat, new SocketBlueprint(Ring: 24, Segment: 5, Rows: 6, Columns: 2), Span: 1.4, Chord: 0.5, Rise: 0.5, Sweep: 0.1),
        JsonLayout.Indented,
        (visit, wing) => new WingBlueprint(
            visit.Choice("style", wing.Style, AnatomyChoices.Wing),
            visit.Record("socket", wing.Socket, Socket),
            visit.Number("span", wing.Span, span),
            visit.Number("chord", wing.Chord, span),
            visit.Number("rise", wing.Rise, new NumberRange(-1, 2)),
            visit.Number("sweep", wing.Sweep, new NumberRange(-1, 2))));

    /// <summary>A pair of insect wings.</summary>
    public static readonly RecordDescription<InsectWingBlueprint> InsectWing = new(
        new InsectWingBlueprint(Ring: 26, Segment: 2.6, Length: 1, Width: 0.2, Azimuth: 0, Elevation: 0.6),
        JsonLayout.Indented,
        (visit, wing) => new InsectWingBlueprint(
            visit.Number("ring", wing.Ring, Ring),
            visit.Number("segment", wing.Segment, Segment),
            visit.Number("length", wing.Length, span),
            visit.Number("width", wing.Width, new NumberRange(0.005, 10)),
            visit.Number("azimuth", wing.Azimuth, Angle),
            visit.Number("elevation", wing.Elevation, Angle),
            visit.Since(5).Choice("style", wing.Style, AnatomyChoices.ThinWing)));

    /// <summary>A fin or a pair of fins.</summary>
    public static readonly RecordDescription<FinBlueprint> Fin = new(
        new FinBlueprint(FinPlace.Dorsal, FinStyle.Sail, new SocketBlueprint(Ring: 24, Segment: 31, Rows: 8, Columns: 2), Length: 0.2, Width: 0, Drop: 0, Sweep: 0.4),
        JsonLayout.Indented,
        (visit, fin) => new FinBlueprint(
            visit.Choice("place", fin.Place, AnatomyChoices.FinPlace),
            visit.Choice("style", fin.Style, AnatomyChoices.Fin),
            visit.Record("socket", fin.Socket, Socket),
            visit.Number("length", fin.Length, new NumberRange(0.01, 5)),
            visit.Number("width", fin.Width, new NumberRange(0, 2)),
            visit.Number("drop", fin.Drop, new NumberRange(-2, 2)),
            visit.Number("sweep", fin.Sweep, new NumberRange(-2, 3))));

    /// <summary>A pair of ears.</summary>
    public static readonly RecordDescription<EarBlueprint> Ear = new(
        new EarBlueprint(new SocketBlueprint(Ring: 13, Segment: 2, Rows: 2, Columns: 2), Length: 0.15, Width: 0.06, Outward: 0.4, Upward: 1, Forward: -0.25, Droop: 0, Roundness: 0),
        JsonLayout.Indented,
        (visit, ear) => new EarBlueprint(
            visit.Record("socket", ear.Socket, Socket),
            visit.Number("length", ear.Length, new NumberRange(0.005, 5)),
            visit.Number("width", ear.Width, new NumberRange(0.002, 2)),
            visit.Number("outward", ear.Outward, Direction),
            visit.Number("upward", ear.Upward, Direction),
            visit.Number("forward", ear.Forward, Direction),
            visit.Number("droop", ear.Droop, new NumberRange(-1, 2)),
            visit.Number("roundness", ear.Roundness, Fraction)));

    /// <summary>A small solid part.</summary>
    public static readonly RecordDescription<FeatureBlueprint> Feature = new(
        new FeatureBlueprint(FeatureKind.Spike, Ring: 30, Segment: 0, Length: 0.1, Radius: 0.03, Outward: 1, Upward: 0, Forward: 0, Sideward: 0, BendUp: 0, BendForward: 0, BendSide: 0, Flatness: 1, Taper: 1),
        JsonLayout.Indented,
        (visit, feature) => new FeatureBlueprint(
            visit.Choice("kind", feature.Kind, AnatomyChoices.Feature),
            visit.Number("ring", feature.Ring, Ring),
            visit.Number("segment", feature.Segment, Segment),
            visit.Number("length", feature.Length, new NumberRange(0.002, 5)),
            visit.Number("radius", feature.Radius, new NumberRange(0.0005, 1)),
            visit.Number("outward", feature.Outward, Direction),
            visit.Number("upward", feature.Upward, Direction),
            visit.Number("forward", feature.Forward, Direction),
            visit.Number("sideward", feature.Sideward, Direction),
            visit.Number("bendUp", feature.BendUp, new NumberRange(-3, 3)),
            visit.Number("bendForward", feature.BendForward, new NumberRange(-3, 3)),
            visit.Number("bendSide", feature.BendSide, new NumberRange(-3, 3)),
            visit.Number("flatness", feature.Flatness, new NumberRange(0.05, 4)),
            visit.Number("taper", feature.Taper, new NumberRange(0.1, 4))));

    /// <summary>The end of the tail.</summary>
    public static readonly RecordDescription<TailBlueprint> Tail = new(
        new TailBlueprint(TailStyle.Plain, 0, 0),
        JsonLayout.Line,
        (visit, tail) => new TailBlueprint(
            visit.Choice("style", tail.Style, AnatomyChoices.Tail),
            visit.Number("size", tail.Size, new NumberRange(0, 3)),
            visit.Number("fork", tail.Fork, new NumberRange(-4, 4)),
            visit.Number("lobe", tail.Lobe, new NumberRange(-0.8, 0.8))));
}
