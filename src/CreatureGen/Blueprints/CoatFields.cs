using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;
using static CreatureGen.Blueprints.CommonRanges;

namespace CreatureGen.Blueprints;

/// <summary>The fields of the skin's colours and pattern.</summary>
internal static class CoatFields
{
    /// <summary>A colour.</summary>
    public static readonly RecordDescription<ColourBlueprint> Colour = new(
        new ColourBlueprint(0.6, 0.05, 1.2),
        JsonLayout.Line,
        (visit, colour) => new ColourBlueprint(
            visit.Number("lightness", colour.Lightness, Fraction),
            visit.Number("chroma", colour.Chroma, new NumberRange(0, 0.5)),
            visit.Number("hue", colour.Hue, new NumberRange(-PortableMath.Tau, PortableMath.Tau))));

    /// <summary>The coat.</summary>
    public static readonly RecordDescription<CoatBlueprint> Coat = new(
        new CoatBlueprint(
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            Colour.Neutral,
            PatternKind.Plain,
            1,
            0,
            0),
        JsonLayout.Indented,
        (visit, coat) => new CoatBlueprint(
            visit.Record("base", coat.Base, Colour),
            visit.Record("back", coat.Back, Colour),
            visit.Record("belly", coat.Belly, Colour),
            visit.Record("limb", coat.Limb, Colour),
            visit.Record("pattern", coat.Pattern, Colour),
            visit.Record("accent", coat.Accent, Colour),
            visit.Record("claw", coat.Claw, Colour),
            visit.Record("horn", coat.Horn, Colour),
            visit.Record("muzzle", coat.Muzzle, Colour),
            visit.Record("mouth", coat.Mouth, Colour),
            visit.Record("tongue", coat.Tongue, Colour),
            visit.Record("iris", coat.Iris, Colour),
            visit.Choice("patternKind", coat.PatternKind, AnatomyChoices.Pattern),
            visit.Number("patternScale", coat.PatternScale, new NumberRange(0.1, 10)),
            visit.Number("patternStrength", coat.PatternStrength, Fraction),
            visit.Whole("patternSeed", coat.PatternSeed, new WholeRange(0, int.MaxValue)),
            visit.Whole("marks", coat.Marks, new WholeRange(0, int.MaxValue))));
}
