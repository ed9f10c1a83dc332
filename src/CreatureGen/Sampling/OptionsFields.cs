using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Sampling;

/// <summary>The fields of the options.</summary>
internal static class OptionsFields
{
    private static readonly ChoiceNames<RequestedKind> kinds = new(
        (RequestedKind.Any, "any"),
        (RequestedKind.Walking, "walking"),
        (RequestedKind.Flying, "flying"),
        (RequestedKind.Swimming, "swimming"));

    private static readonly ChoiceNames<PaletteMood> palettes = new(
        (PaletteMood.Any, "any"),
        (PaletteMood.Natural, "natural"),
        (PaletteMood.Vivid, "vivid"),
        (PaletteMood.Pale, "pale"),
        (PaletteMood.Dark, "dark"));

    private static readonly ChoiceNames<OrnamentLevel> levels = new(
        (OrnamentLevel.None, "none"),
        (OrnamentLevel.Sparse, "sparse"),
        (OrnamentLevel.Normal, "normal"),
        (OrnamentLevel.Rich, "rich"));

    private static readonly NumberRange weight = new(0, 1000);
    private static readonly WholeRange legPairs = new(0, CreatureFields.MaxLegs);

    /// <summary>Weight of a body plan.</summary>
    public static readonly RecordDescription<BodyPlanWeight> PlanWeight = new(
        new BodyPlanWeight(BodyPlan.Digitigrade, 1),
        JsonLayout.Line,
        (visit, plan) => new BodyPlanWeight(
            visit.Choice("plan", plan.Plan, AnatomyChoices.Plan),
            visit.Number("weight", plan.Weight, weight)));

    /// <summary>Weight of a base body.</summary>
    public static readonly RecordDescription<BaseBodyWeight> BodyWeight = new(
        new BaseBodyWeight(BaseBodyNames.All[0], 1),
        JsonLayout.Line,
        (visit, body) => new BaseBodyWeight(
            visit.Word("name", body.Name, BaseBodyNames.All),
            visit.Number("weight", body.Weight, weight)));

    /// <summary>The options.</summary>
    public static readonly RecordDescription<CreatureOptions> Options = new(
        CreatureOptions.Default,
        JsonLayout.Indented,
        (visit, options) => new CreatureOptions
        {
            Kind = visit.Choice("kind", options.Kind, kinds),
            MinScale = visit.Number("minScale", options.MinScale, CreatureFields.Scale),
            MaxScale = visit.Number("maxScale", options.MaxScale, CreatureFields.Scale),
            MinLegPairs = visit.Whole("minLegPairs", options.MinLegPairs, legPairs),
            MaxLegPairs = visit.Whole("maxLegPairs", options.MaxLegPairs, legPairs),
            BodyPlans = visit.List("bodyPlans", options.BodyPlans, new WholeRange(0, AnatomyChoices.Plan.Count), PlanWeight),
            BaseBodies = visit.List("baseBodies", options.BaseBodies, new WholeRange(0, BaseBodyNames.All.Count), BodyWeight),
            Strangeness = visit.Number("strangeness", options.Strangeness, CommonRanges.Fraction),
            Palette = visit.Choice("palette", options.Palette, palettes),
            Ornaments = visit.Choice("ornaments", options.Ornaments, levels),
            TriangleBudget = visit.Whole("triangleBudget", options.TriangleBudget, CreatureFields.TriangleBudget),
            Individual = visit.OptionalText("individual", options.Individual),
        });
}
