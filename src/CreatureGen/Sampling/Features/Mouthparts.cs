using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;
using CreatureGen.Species;
using CreatureGen.Species.Catalogue;

namespace CreatureGen.Sampling.Features;

/// <summary>Jaws of insects' heads on strange creatures: theirs come with the ornaments, which another parent may give, and moths and flies have none that are seen; without any such a head is a blob from the front.</summary>
internal static class Mouthparts
{
    // Length of a jaw in half heights of its head, its radius in lengths, and how far it varies.
    private const double Length = 0.62;
    private const double Radius = 0.21;
    private const double Least = 0.85;
    private const double Most = 1.2;

    /// <summary>Adds a pair of jaws to an insect's head that has none.</summary>
    public static void Add(CreatureBuilder builder)
    {
        if (builder.Parents.Head.Class != AnimalClass.Arthropod || builder.Fitting == 0 || builder.Features.Exists(part => part.Kind == FeatureKind.Mandible))
        {
            return;
        }

        RandomStream random = builder.Stream("jaws");
        double length = Length * random.Uniform(Least, Most) * HeadSampler.HalfHeight(builder.Shape);
        FeatureBlueprint jaw = InsectParts.Jaw(length, Radius * length, sideward: 0.1, bendUp: 0, bendSide: -0.5);
        builder.Features.Add(FeatureSampler.OffGround(builder, jaw));
    }
}
