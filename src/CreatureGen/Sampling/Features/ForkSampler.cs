using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Features;

/// <summary>Two heads on two necks, where the neck of a strange creature has room to fork. How often follows the strangeness.</summary>
internal static class ForkSampler
{
    /// <summary>Probability at full strangeness; it falls with the cube of that, for two heads are the first that anybody tells of a creature.</summary>
    private const double Any = 0.085;

    // Two heads weigh about as much as one where each has this size.
    private const double LeastSize = 0.78;
    private const double MostSize = 0.88;

    /// <summary>Most pairs of legs: on more of them the joints of a second neck would be too many for engines.</summary>
    private const int MostLegs = 8;

    /// <summary>The creature, with two heads if it has them.</summary>
    public static CreatureBlueprint Add(CreatureBuilder builder, CreatureBlueprint creature)
    {
        RandomStream random = builder.Stream("second head");
        bool forks = random.Chance(Any * PortableMath.Pow(builder.Strangeness, 3));
        double size = random.Uniform(LeastSize, MostSize);
        return forks && creature.Legs.Count <= MostLegs && ForkFit.Find(creature, builder.Shape, size) is ForkBlueprint fork ? creature with { Fork = fork } : creature;
    }
}
