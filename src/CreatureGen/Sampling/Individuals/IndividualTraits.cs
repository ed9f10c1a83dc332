using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Individuals;

/// <summary>In what one individual differs from the type of its species: factors unless they say otherwise. A grown one differs by 5 to 25 %, a young one by up to 45 %.</summary>
/// <remarks>
/// Each trait comes from a stream of its own. Young animals have large heads and eyes, short snouts, legs and necks, and hardly any horns
/// (K. Lorenz 1943, "Die angeborenen Formen möglicher Erfahrung").
/// </remarks>
internal sealed record IndividualTraits
{
    /// <summary>Share of individuals that are grown.</summary>
    private const double Grown = 0.65;

    /// <summary>The oldest of the young.</summary>
    private const double MinYouth = 0.35;

    private IndividualTraits(Seed seed) => Seed = seed;

    /// <summary>Root of the individual's streams.</summary>
    public Seed Seed { get; }

    /// <summary>0 for a grown one to 1 for a newborn.</summary>
    public double Youth { get; private init; }

    public double Size { get; private init; }

    public double Head { get; private init; }

    public double Snout { get; private init; }

    public double Neck { get; private init; }

    public double Girth { get; private init; }

    public double Belly { get; private init; }

    public double Chest { get; private init; }

    public double Rump { get; private init; }

    public double Tail { get; private init; }

    /// <summary>Added to the share of the plan's range of heights.</summary>
    public double Stance { get; private init; }

    public double LegGirth { get; private init; }

    public double Eyes { get; private init; }

    public double Ears { get; private init; }

    /// <summary>Length of horns, antlers and tusks.</summary>
    public double Horns { get; private init; }

    /// <summary>Length of all other parts.</summary>
    public double Parts { get; private init; }

    public double Claws { get; private init; }

    public double Wings { get; private init; }

    public double Fins { get; private init; }

    /// <summary>Swellings and hollows of the skull.</summary>
    public double Bones { get; private init; }

    /// <summary>Tilts of head, neck and tail, standard deviations.</summary>
    public (double Head, double Neck, double Tail) Tilt { get; private init; }

    /// <summary>The traits of an individual of the species of a seed.</summary>
    public static IndividualTraits Draw(Seed species, ulong individual)
    {
        Seed seed = species.Child("individual").Child(unchecked((int)(individual >> 32))).Child(unchecked((int)individual));
        double age = seed.Child("age").Stream().Uniform();
        double youth = age < Grown ? 0 : Scalar.Lerp(MinYouth, 1, (age - Grown) / (1 - Grown));
        RandomStream size = seed.Child("size").Stream();
        double fraction = size.Uniform(0.05, 0.2);
        double adult = size.Chance(0.5) ? 1 + fraction : 1 - fraction;
        return new IndividualTraits(seed)
        {
            Youth = youth,
            Size = Scalar.Clamp(adult * (1 - (0.42 * youth)), 0.55, 1.2),
            Head = Around("head", 0.05, 0.3),
            Snout = Around("snout", 0.08, -0.2),
            Neck = Around("neck", 0.08, -0.2),
            Girth = Around("girth", 0.06, 0.04),
            Belly = Around("belly", 0.05, 0),
            Chest = Around("chest", 0.04, -0.03),
            Rump = Around("rump", 0.04, -0.03),
            Tail = Around("tail", 0.08, -0.15),
            Stance = Scalar.Clamp(Draw("stance", 0.15), -0.3, 0.3) - (0.35 * youth),
            LegGirth = Around("leg girth", 0.06, 0.06),
            Eyes = Around("eyes", 0.04, 0.18),
            Ears = Around("ears", 0.1, 0.05),
            Horns = Around("horns", 0.14, -0.6),
            Parts = Around("parts", 0.1, -0.15),
            Claws = Around("claws", 0.1, -0.3),
            Wings = Around("wings", 0.05, -0.12),
            Fins = Around("fins", 0.07, -0.1),
            Bones = Around("bones", 0.12, -0.2),
            Tilt = (Draw("head tilt", 1), Draw("neck tilt", 1), Draw("tail tilt", 1)),
        };

        double Draw(string name, double deviation) => seed.Child(name).Stream().Normal(0, deviation);

        // The young one's factor is added to, so that the two never multiply beyond what a body carries.
        double Around(string name, double deviation, double ofYoung) => seed.Child(name).Stream().LogNormal(deviation, 0.8, 1.25) + (ofYoung * youth);
    }
}
