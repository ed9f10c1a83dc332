using System;
using CreatureGen.Maths;
using CreatureGen.Sampling.Parents;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>
/// How large a creature is. Animals differ five hundredfold in length, games' creatures by what the options allow: the place of its torso between the smallest and the greatest of the catalogue, by logarithms,
/// says what part of the sizes that are asked for is its own. So who is larger in life is larger in the game, whatever the options, and the small are not made tiny: who watches wants to see them.
/// </summary>
internal static class NaturalSize
{
    /// <summary>Torsos of the smallest and the greatest animals of the catalogue, metres: ants and horned dinosaurs.</summary>
    public const double Smallest = 0.006;
    public const double Greatest = 3;

    /// <summary>Part of the range of sizes that lies below all that are as the smallest animals are: that is for strange ones and for individuals that are small for their kind.</summary>
    public const double Floor = 0.4;

    /// <summary>How far strangeness moves the ends of a creature's range outward, parts of that from the smallest to the greatest: at full strangeness a wolf may be as small as a parrot or as large as anything.</summary>
    public const double Loosened = 0.25;

    /// <summary>Size of a creature as its blueprint tells it.</summary>
    public static double Draw(CreatureBuilder builder, CreatureOptions options)
    {
        (double from, double to) = RangeOf(builder.Parents, builder.Strangeness);
        double place = builder.Stream("scale").Uniform(from, to);
        double least = PortableMath.Log(options.MinScale);
        double size = PortableMath.Exp(least + (ShareOf(place) * (PortableMath.Log(options.MaxScale) - least)));

        // An end of the range may come out a bit beyond what was asked for.
        return Scalar.Clamp(size, options.MinScale, options.MaxScale);
    }

    /// <summary>Range of a mix between the smallest animals, 0, and the greatest, 1: its parents' by their shares in the torso, wider by strangeness.</summary>
    public static (double From, double To) RangeOf(Parentage parents, double strangeness)
    {
        (double first, double second, double third) = parents.Torso;
        (double from, double to) = (0, 0);
        Add(parents.First, first);
        Add(parents.Second, second);
        Add(parents.Third, third);
        double wider = Loosened * strangeness;
        return (from - wider, Math.Min(1, to + wider));

        void Add(SpeciesProfile parent, double share)
        {
            from += share * PlaceOf(parent.TorsoLength.Min);
            to += share * PlaceOf(parent.TorsoLength.Max);
        }
    }

    /// <summary>Where a torso lies between the smallest, 0, and the greatest, 1.</summary>
    /// <param name="length">Metres.</param>
    public static double PlaceOf(double length) => PortableMath.Log(length / Smallest) / PortableMath.Log(Greatest / Smallest);

    /// <summary>Where a creature lies in the range of sizes that is asked for, 0..1, by logarithms: the same step counts for more among the large, as it does to the eye.</summary>
    /// <param name="place">Between the smallest, 0, and the greatest, 1; strange ones may be below.</param>
    private static double ShareOf(double place) => Floor + (place < 0 ? place : (1 - Floor) * place * Math.Sqrt(place));
}
