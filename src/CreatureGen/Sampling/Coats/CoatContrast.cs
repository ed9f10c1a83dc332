using System;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Coats;

/// <summary>
/// Keeps the coat of a mixed body within what shows its form: a swan's white and a raven's black are known by their animals' outlines, and without these a white body is blank and a black one a hole.
/// Light and shade of OKLCH; hues and chroma stay.
/// </summary>
internal static class CoatContrast
{
    // Lightness of the base of a mixed coat, at least and at most, and of its other fields at least.
    private const double Darkest = 0.36;
    private const double Palest = 0.8;
    private const double DarkestField = 0.25;

    // From which lightness on a coat is pale, and by how much its back and limbs are darker than a pale base.
    private const double Pale = 0.68;
    private const double Below = 0.22;

    /// <summary>Least difference of lightness between base and pattern.</summary>
    private const double PatternApart = 0.16;

    /// <summary>The coat as a body wears it.</summary>
    /// <param name="coat">As it was drawn.</param>
    /// <param name="mixed">0 for an animal, which keeps its coat, to 1 for a body of several.</param>
    public static CoatBlueprint On(CoatBlueprint coat, double mixed)
    {
        if (mixed == 0)
        {
            return coat;
        }

        double lightness = Scalar.Clamp(coat.Base.Lightness, Darkest, Palest);
        double pale = Scalar.Smooth((lightness - Pale) / (Palest - Pale));
        double apart = coat.Pattern.Lightness - lightness;
        double pattern = Math.Abs(apart) >= PatternApart ? coat.Pattern.Lightness : lightness + (apart > 0 && lightness < Pale ? PatternApart : -PatternApart);
        return coat with
        {
            Base = Towards(coat.Base, lightness, mixed),
            Back = Towards(coat.Back, Darker(coat.Back, lightness - Below, pale), mixed),
            Limb = Towards(coat.Limb, Darker(coat.Limb, lightness - Below, pale), mixed),
            Pattern = Towards(coat.Pattern, pattern, mixed),
        };
    }

    /// <summary>Lightness of a field, no darker than the darkest, and on a pale coat no paler than a bound.</summary>
    private static double Darker(ColourBlueprint field, double most, double pale) => Math.Max(Scalar.Lerp(field.Lightness, Math.Min(field.Lightness, most), pale), DarkestField);

    private static ColourBlueprint Towards(ColourBlueprint field, double lightness, double share) => field with { Lightness = Scalar.Lerp(field.Lightness, lightness, share) };
}
