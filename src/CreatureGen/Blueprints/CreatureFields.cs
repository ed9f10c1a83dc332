using CreatureGen.Anatomy;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>The fields of a whole creature.</summary>
internal static class CreatureFields
{
    /// <summary>The name of the field that says by which algorithm a seed became this creature.</summary>
    public const string Algorithm = "algorithm";

    /// <summary>Most pairs of legs and arms.</summary>
    public const int MaxLegs = 16;

    /// <summary>Most small parts.</summary>
    public const int MaxFeatures = 64;

    /// <summary>Size of a whole creature.</summary>
    public static readonly NumberRange Scale = new(0.05, 20);

    /// <summary>Triangles at the finest level of detail.</summary>
    public static readonly WholeRange TriangleBudget = new(6000, 100000);

    /// <summary>The creature.</summary>
    public static readonly RecordDescription<CreatureBlueprint> Creature = new(
        new CreatureBlueprint(
            CreatureBlueprint.CurrentAlgorithm,
            0,
            LocomotionKind.Walking,
            BodyPlan.Legless,
            1,
            20000,
            BodyFields.Body.Neutral,
            HeadFields.Head.Neutral,
            LimbFields.Tail.Neutral,
            ValueList<LegBlueprint>.Empty,
            ValueList<WingBlueprint>.Empty,
            ValueList<InsectWingBlueprint>.Empty,
            ValueList<FinBlueprint>.Empty,
            ValueList<EarBlueprint>.Empty,
            ValueList<FeatureBlueprint>.Empty,
            ValueList<ManeBlueprint>.Empty,
            ValueList<FrillBlueprint>.Empty,
            CoatFields.Coat.Neutral),
        JsonLayout.Indented,
        (visit, creature) => new CreatureBlueprint(
            VisitHeading(visit, creature),
            visit.UnsignedText("seed", creature.Seed),
            visit.Choice("kind", creature.Kind, AnatomyChoices.Kind),
            visit.Choice("plan", creature.Plan, AnatomyChoices.Plan),
            visit.Number("scale", creature.Scale, Scale),
            visit.Whole("triangleBudget", creature.TriangleBudget, TriangleBudget),
            visit.Record("body", creature.Body, BodyFields.Body),
            visit.Record("head", creature.Head, HeadFields.Head),
            visit.Record("tail", creature.Tail, LimbFields.Tail),
            visit.List("legs", creature.Legs, new WholeRange(0, MaxLegs), LimbFields.Leg),
            visit.List("wings", creature.Wings, new WholeRange(0, 4), LimbFields.Wing),
            visit.List("insectWings", creature.InsectWings, new WholeRange(0, 4), LimbFields.InsectWing),
            visit.List("fins", creature.Fins, new WholeRange(0, 12), LimbFields.Fin),
            visit.List("ears", creature.Ears, new WholeRange(0, 2), LimbFields.Ear),
            visit.List("features", creature.Features, new WholeRange(0, MaxFeatures), LimbFields.Feature),
            visit.List("manes", creature.Manes, new WholeRange(0, 6), NeckFields.Mane),
            visit.List("frills", creature.Frills, new WholeRange(0, 2), NeckFields.Frill),
            visit.Record("coat", creature.Coat, CoatFields.Coat),
            visit.Since(4).Optional("lineage", creature.Lineage, LineageFields.Lineage),
            visit.Since(5).Optional("fork", creature.Fork, NeckFields.Fork)));

    /// <summary>The number of the format belongs to the text and not to the creature; that of the algorithm to both.</summary>
    private static int VisitHeading(IFieldVisitor visit, CreatureBlueprint creature)
    {
        visit.Version(BlueprintFormat.Field, BlueprintFormat.Current, BlueprintFormat.Current);
        return visit.Version(Algorithm, creature.Algorithm, CreatureBlueprint.CurrentAlgorithm);
    }
}
