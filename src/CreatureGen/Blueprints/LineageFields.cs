using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>The fields of a lineage.</summary>
internal static class LineageFields
{
    private static readonly ChoiceNames<ParentName> parent = new((ParentName.First, "first"), (ParentName.Second, "second"));

    /// <summary>Where a bred creature comes from.</summary>
    public static readonly RecordDescription<LineageBlueprint> Lineage = new(
        new LineageBlueprint(Generation: 1, First: 0, Second: 0, Mutation: 0, Frame: ParentName.First, Head: ParentName.First, Tail: ParentName.First, Ornaments: ParentName.First, Skin: ParentName.First),
        JsonLayout.Indented,
        (visit, lineage) => new LineageBlueprint(
            visit.Whole("generation", lineage.Generation, new WholeRange(1, 1_000_000)),
            visit.UnsignedText("first", lineage.First),
            visit.UnsignedText("second", lineage.Second),
            visit.Number("mutation", lineage.Mutation, CommonRanges.Fraction),
            visit.Choice("frame", lineage.Frame, parent),
            visit.Choice("head", lineage.Head, parent),
            visit.Choice("tail", lineage.Tail, parent),
            visit.Choice("ornaments", lineage.Ornaments, parent),
            visit.Choice("skin", lineage.Skin, parent)));
}
