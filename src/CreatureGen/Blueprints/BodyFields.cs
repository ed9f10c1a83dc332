using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;
using static CreatureGen.Blueprints.CommonRanges;

namespace CreatureGen.Blueprints;

/// <summary>The fields of the trunk.</summary>
internal static class BodyFields
{
    /// <summary>Slices of the lattice.</summary>
    public const int SliceCount = 11;

    /// <summary>Radians that a neck or a tail may bend in all.</summary>
    private static readonly double wholeBend = Scalar.Radians(100);

    private static readonly NumberRange neckBend = new(-wholeBend / BodyGrid.NeckBones, wholeBend / BodyGrid.NeckBones);
    private static readonly NumberRange tailBend = new(-wholeBend / BodyGrid.TailBones, wholeBend / BodyGrid.TailBones);

    /// <summary>Most bodies in a mix.</summary>
    public const int MaxBodies = 6;

    /// <summary>One body of a mix.</summary>
    public static readonly RecordDescription<MixedBody> Mixed = new(
        new MixedBody(BaseBodyNames.All[0], 1, 1, 1),
        JsonLayout.Line,
        (visit, part) => new MixedBody(
            visit.Word("name", part.Name, BaseBodyNames.All),
            visit.Number("torso", part.Torso, Fraction),
            visit.Number("head", part.Head, Fraction),
            visit.Number("tail", part.Tail, Fraction)));

    /// <summary>Mix of base bodies.</summary>
    public static readonly RecordDescription<BodyBlend> Blend = new(
        new BodyBlend(new ValueList<MixedBody>(new[] { Mixed.Neutral }), BaseBodyNames.All[0], BaseBodyNames.All[0], BaseBodyNames.All[0]),
        JsonLayout.Indented,
        (visit, blend) => new BodyBlend(
            visit.List("bodies", blend.Bodies, new WholeRange(1, MaxBodies), Mixed),
            visit.Word("face", blend.Face, BaseBodyNames.All),
            visit.Word("skin", blend.Skin, BaseBodyNames.All),
            visit.Word("manner", blend.Manner, BaseBodyNames.All)));

    /// <summary>Factors on parts of the body.</summary>
    public static readonly RecordDescription<BodyProportions> Proportions = new(
        new BodyProportions(Head: 1, Snout: 1, Neck: 1, NeckGirth: 1, Girth: 1, Belly: 1, Chest: 1, Hump: 1, Rump: 1, Tail: 1, TailGirth: 1, Depth: 1, Width: 1),
        JsonLayout.Indented,
        (visit, body) => new BodyProportions(
            visit.Number("head", body.Head, Factor),
            visit.Number("snout", body.Snout, Factor),
            visit.Number("neck", body.Neck, Factor),
            visit.Number("neckGirth", body.NeckGirth, Factor),
            visit.Number("girth", body.Girth, Factor),
            visit.Number("belly", body.Belly, Factor),
            visit.Number("chest", body.Chest, Factor),
            visit.Number("hump", body.Hump, Factor),
            visit.Number("rump", body.Rump, Factor),
            visit.Number("tail", body.Tail, Factor),
            visit.Number("tailGirth", body.TailGirth, Factor),
            visit.Number("depth", body.Depth, Factor),
            visit.Number("width", body.Width, Factor)));

    /// <summary>Angles of the spine.</summary>
    public static readonly RecordDescription<BodyPosture> Posture = new(
        new BodyPosture(Head: 0, Neck: 0, Torso: 0, Tail: 0, Trunk: 0, NeckBend: 0, TailBend: 0),
        JsonLayout.Indented,
        (visit, posture) => new BodyPosture(
            visit.Number("head", posture.Head, Angle),
            visit.Number("neck", posture.Neck, Angle),
            visit.Number("torso", posture.Torso, Angle),
            visit.Number("tail", posture.Tail, Angle),
            visit.Number("trunk", posture.Trunk, Angle),
            visit.Number("neckBend", posture.NeckBend, neckBend),
            visit.Number("tailBend", posture.TailBend, tailBend)));

    /// <summary>One slice of the lattice.</summary>
    public static readonly RecordDescription<LatticeSlice> Slice = new(
        new LatticeSlice(1, 1, 1),
        JsonLayout.Line,
        (visit, slice) => new LatticeSlice(
            visit.Number("width", slice.Width, Factor),
            visit.Number("height", slice.Height, Factor),
            visit.Number("length", slice.Length, Factor)));

    /// <summary>Hard cover over the back.</summary>
    public static readonly RecordDescription<ShellBlueprint> Shell = new(
        new ShellBlueprint(ShellStyle.None, Ring: 24, Rows: 20, Columns: 6, Rise: 0),
        JsonLayout.Line,
        (visit, shell) => new ShellBlueprint(
            visit.Choice("style", shell.Style, AnatomyChoices.Shell),
            visit.Whole("ring", shell.Ring, new WholeRange(16, 50)),
            visit.Whole("rows", shell.Rows, new WholeRange(2, 36)),
            visit.Whole("columns", shell.Columns, new WholeRange(2, 12)),
            visit.Number("rise", shell.Rise, new NumberRange(0, 0.5))));

    /// <summary>Rings of the rear of the body.</summary>
    public static readonly RecordDescription<AnnuliBlueprint> Annuli = new(
        new AnnuliBlueprint(41, 0),
        JsonLayout.Line,
        (visit, annuli) => new AnnuliBlueprint(
            visit.Whole("ring", annuli.Ring, new WholeRange(16, 50)),
            visit.Number("depth", annuli.Depth, new NumberRange(0, 0.3))));

    /// <summary>Edges of a wide body.</summary>
    public static readonly RecordDescription<DiscBlueprint> Disc = new(
        new DiscBlueprint(0, 0),
        JsonLayout.Line,
        (visit, disc) => new DiscBlueprint(
            visit.Number("sweep", disc.Sweep, new NumberRange(-1, 1)),
            visit.Number("curl", disc.Curl, new NumberRange(-1, 1))));

    /// <summary>The trunk.</summary>
    public static readonly RecordDescription<BodyBlueprint> Body = new(
        new BodyBlueprint(Blend.Neutral, Proportions.Neutral, Posture.Neutral, new ValueList<LatticeSlice>(Enumerable.Repeat(Slice.Neutral, SliceCount)), 0.5, Shell.Neutral, Annuli.Neutral, Disc.Neutral),
        JsonLayout.Indented,
        (visit, body) => new BodyBlueprint(
            visit.Record("blend", body.Blend, Blend),
            visit.Record("proportions", body.Proportions, Proportions),
            visit.Record("posture", body.Posture, Posture),
            visit.List("slices", body.Slices, new WholeRange(SliceCount, SliceCount), Slice),
            visit.Number("elevation", body.Elevation, new NumberRange(0, 10)),
            visit.Record("shell", body.Shell, Shell),
            visit.Record("annuli", body.Annuli, Annuli),
            visit.Record("disc", body.Disc, Disc)));
}
