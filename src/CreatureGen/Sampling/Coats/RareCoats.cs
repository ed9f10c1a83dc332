using System;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using static CreatureGen.Sampling.Coats.CoatSampler;

namespace CreatureGen.Sampling.Coats;

/// <summary>Species without dark pigment, and species with nothing else.</summary>
/// <remarks>Each is as frequent as <see cref="Odds"/> wherever the mood allows it: natural and vivid coats are neither white nor black, pale ones never black, dark ones never white.</remarks>
internal static class RareCoats
{
    /// <summary>Probability of each.</summary>
    public const double Odds = 1 / 80.0;

    /// <summary>By how much darker the back of a mixed albino is, and the least strength of its pattern.</summary>
    private const double DarkerBack = 0.02;
    private const double LeastPattern = 0.65;

    /// <summary>The coat, or one of its rare forms.</summary>
    /// <param name="coat">As it would be.</param>
    /// <param name="palette">The mood that is asked for.</param>
    /// <param name="random">Decides.</param>
    /// <param name="mixed">0 for an animal, 1 for a body of several: without a pattern that has no form to the eye.</param>
    public static CoatBlueprint Perhaps(CoatBlueprint coat, PaletteMood palette, RandomStream random, double mixed)
    {
        double drawn = random.Uniform();
        if (drawn < Odds)
        {
            return palette is PaletteMood.Any or PaletteMood.Pale ? Albino(coat, random, mixed) : coat;
        }

        return drawn < 2 * Odds && palette is (PaletteMood.Any or PaletteMood.Dark) ? Melanistic(coat, random) : coat;
    }

    /// <summary>Nearly white with a warm tint; blood shows through eyes, nose and ears. A breath of the pattern is left on half of all animals, and on whatever is mixed.</summary>
    private static CoatBlueprint Albino(CoatBlueprint coat, RandomStream random, double mixed)
    {
        double lightness = random.Uniform(0.89, 0.92);
        double chroma = random.Uniform(0.012, 0.022);
        double hue = random.Uniform(50, 95);
        return coat with
        {
            Base = Colour(lightness, chroma, hue),
            Back = Colour(lightness - 0.03 - (DarkerBack * mixed), chroma * 1.2, hue),
            Belly = Colour(0.945, chroma * 0.6, hue),
            Limb = Colour(lightness - 0.05, chroma * 1.6, hue - 20),
            Pattern = Colour(lightness - 0.10, chroma * 2, hue - 10),
            Accent = Colour(0.82, 0.06, 25),
            Claw = Colour(0.80, 0.045, 40),
            Horn = Colour(0.83, 0.035, 70),
            Muzzle = Colour(0.74, 0.085, 18),
            Mouth = Colour(0.55, 0.11, 18),
            Iris = Colour(random.Uniform(0.56, 0.63), random.Uniform(0.14, 0.17), random.Uniform(8, 20)),
            PatternStrength = Math.Max(random.Chance(0.5) ? 0 : random.Uniform(0.4, 0.8), LeastPattern * mixed),
        };
    }

    /// <summary>Nearly black with a trace of its own hue; its pattern shows as a ghost, darker still, and its eyes shine.</summary>
    private static CoatBlueprint Melanistic(CoatBlueprint coat, RandomStream random)
    {
        double lightness = random.Uniform(0.25, 0.27);
        double chroma = Math.Min(coat.Base.Chroma, 0.02);
        double hue = Scalar.Degrees(coat.Base.Hue);
        return coat with
        {
            Base = Colour(lightness, chroma, hue),
            Back = Colour(lightness - 0.03, chroma, hue),
            Belly = Colour(lightness + 0.03, chroma, hue),
            Limb = Colour(lightness - 0.04, chroma, hue),
            Pattern = Colour(0.135, chroma * 0.7, hue),
            Accent = Colour(0.33, Math.Min(coat.Accent.Chroma, 0.05), Scalar.Degrees(coat.Accent.Hue)),
            Claw = Colour(0.36, 0.015, 60),
            Horn = Colour(0.36, 0.02, 70),
            Muzzle = Colour(0.18, 0.015, 40),
            Iris = Colour(random.Uniform(0.75, 0.82), random.Uniform(0.13, 0.17), random.Uniform(70, 125)),
            PatternStrength = 1,
        };
    }
}
