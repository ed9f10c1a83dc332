using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;
using static CreatureGen.Blueprints.CommonRanges;

namespace CreatureGen.Blueprints;

/// <summary>The fields of the face.</summary>
internal static class HeadFields
{
    private static readonly NumberRange opening = new(0, PortableMath.Pi);

    /// <summary>A swelling or a hollow.</summary>
    public static readonly RecordDescription<HeadBump> Bump = new(
        new HeadBump(Ring: 8, Segment: 8, RingSpread: 1, SegmentSpread: 1, Amount: 0),
        JsonLayout.Line,
        (visit, bump) => new HeadBump(
            visit.Number("ring", bump.Ring, Ring),
            visit.Number("segment", bump.Segment, Segment),
            visit.Number("ringSpread", bump.RingSpread, new NumberRange(0.1, 20)),
            visit.Number("segmentSpread", bump.SegmentSpread, new NumberRange(0.1, 16)),
            visit.Number("amount", bump.Amount, new NumberRange(-0.9, 2))));

    /// <summary>Eyes.</summary>
    public static readonly RecordDescription<EyeBlueprint> Eyes = new(
        new EyeBlueprint(EyeStyle.Round, Ring: 9.6, Segment: 5.2, Radius: 0.04, Sink: 0.6, Forward: 0.5, UpperLid: 1, LowerLid: 1.1, LidTilt: 0),
        JsonLayout.Indented,
        (visit, eyes) => new EyeBlueprint(
            visit.Choice("style", eyes.Style, AnatomyChoices.Eye),
            visit.Number("ring", eyes.Ring, Ring),
            visit.Number("segment", eyes.Segment, Segment),
            visit.Number("radius", eyes.Radius, new NumberRange(0.001, 1)),
            visit.Number("sink", eyes.Sink, new NumberRange(-0.9, 0.9)),
            visit.Number("forward", eyes.Forward, new NumberRange(0, 2)),
            visit.Number("upperLid", eyes.UpperLid, opening),
            visit.Number("lowerLid", eyes.LowerLid, opening),
            visit.Number("lidTilt", eyes.LidTilt, Angle)));

    /// <summary>Mouth.</summary>
    public static readonly RecordDescription<MouthBlueprint> Mouth = new(
        new MouthBlueprint(CornerRing: 0, Opening: 0, Smile: 0, Teeth: 0),
        JsonLayout.Line,
        (visit, mouth) => new MouthBlueprint(
            visit.Whole("cornerRing", mouth.CornerRing, new WholeRange(0, 12)),
            visit.Number("opening", mouth.Opening, new NumberRange(0, 1)),
            visit.Number("smile", mouth.Smile, new NumberRange(-1, 1)),
            visit.Number("teeth", mouth.Teeth, Fraction),
            visit.Choice("tongue", mouth.Tongue, AnatomyChoices.Tongue)));

    /// <summary>Beak.</summary>
    public static readonly RecordDescription<BeakBlueprint> Beak = new(
        new BeakBlueprint(BeakStyle.Conical, Length: 0.03, Girth: 1, Hook: 0.2),
        JsonLayout.Line,
        (visit, beak) => new BeakBlueprint(
            visit.Choice("style", beak.Style, AnatomyChoices.Beak),
            visit.Number("length", beak.Length, new NumberRange(0.002, 1)),
            visit.Number("girth", beak.Girth, new NumberRange(0.3, 3)),
            visit.Number("hook", beak.Hook, new NumberRange(-1.5, 2.5))));

    /// <summary>The face.</summary>
    public static readonly RecordDescription<HeadBlueprint> Head = new(
        new HeadBlueprint(ValueList<HeadBump>.Empty, 2.2, Eyes.Neutral, Mouth.Neutral, 0),
        JsonLayout.Indented,
        (visit, head) => new HeadBlueprint(
            visit.List("bumps", head.Bumps, new WholeRange(0, 32), Bump),
            visit.Number("muzzleSquareness", head.MuzzleSquareness, new NumberRange(1, 8)),
            visit.Record("eyes", head.Eyes, Eyes),
            visit.Record("mouth", head.Mouth, Mouth),
            visit.Number("nostrilSize", head.NostrilSize, Fraction),
            visit.Since(6).Optional("beak", head.Beak, Beak)));
}
