using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>Every number of one creature: what to build, without how. The same blueprint always builds the same creature.</summary>
/// <remarks>Lengths are in metres at scale 1, where a torso is about one metre long; angles are in radians; all else is a factor unless it says so.</remarks>
/// <param name="Algorithm">Version of the algorithm by which the seed became these numbers, 1..<see cref="CurrentAlgorithm"/>; a record only, as is the seed.</param>
/// <param name="Seed">The seed it was sampled from; a record only, nothing is drawn from it.</param>
/// <param name="Kind">How the creature moves.</param>
/// <param name="Plan">How it carries its body.</param>
/// <param name="Scale">Size of the whole creature.</param>
/// <param name="TriangleBudget">Triangles that the finest level of detail may have.</param>
/// <param name="Body">Trunk, neck, head outline and tail outline.</param>
/// <param name="Head">Face.</param>
/// <param name="Tail">End of the tail.</param>
/// <param name="Legs">Pairs of legs and arms, front to rear; each is built left and mirrored right.</param>
/// <param name="Wings">Pairs of stitched wings.</param>
/// <param name="InsectWings">Pairs of thin wings set on the back.</param>
/// <param name="Fins">Fins, single on the midline or in pairs.</param>
/// <param name="Ears">Pairs of ears.</param>
/// <param name="Features">Horns, spikes, antennae and other small solid parts.</param>
/// <param name="Manes">Fields of hair in locks.</param>
/// <param name="Frills">Collars that stand off the head.</param>
/// <param name="Coat">Colours and pattern.</param>
/// <param name="Lineage">Its parents, if it was bred; null for creatures of seeds.</param>
/// <param name="Fork">Where its body forks into two necks with a head each; null for a creature with one head.</param>
public sealed record CreatureBlueprint(
    int Algorithm,
    ulong Seed,
    LocomotionKind Kind,
    BodyPlan Plan,
    double Scale,
    int TriangleBudget,
    BodyBlueprint Body,
    HeadBlueprint Head,
    TailBlueprint Tail,
    ValueList<LegBlueprint> Legs,
    ValueList<WingBlueprint> Wings,
    ValueList<InsectWingBlueprint> InsectWings,
    ValueList<FinBlueprint> Fins,
    ValueList<EarBlueprint> Ears,
    ValueList<FeatureBlueprint> Features,
    ValueList<ManeBlueprint> Manes,
    ValueList<FrillBlueprint> Frills,
    CoatBlueprint Coat,
    LineageBlueprint? Lineage = null,
    ForkBlueprint? Fork = null)
{
    /// <summary>
    /// Version of the algorithm of this library: the same seed, options and algorithm give the same bytes. It is raised whenever a seed or a blueprint would build other bytes.
    /// </summary>
    public const int CurrentAlgorithm = 42;

    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, CreatureFields.Creature);
}
