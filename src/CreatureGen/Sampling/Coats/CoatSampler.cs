using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Coats;

/// <summary>Draws harmonious colours in OKLCH. Numbers are tendencies of look.md: natural, vivid, pale and dark coats.</summary>
internal static class CoatSampler
{
    /// <summary>Probability that a species wears a colouring that it is known by.</summary>
    private const double KnownColourings = 0.55;

    /// <summary>Probability that a mixed body in a plain coat has a pattern of its animals instead: of one tone from head to foot a body of several is a cast.</summary>
    private const double PatternsOfMixed = 0.3;

    // How far one species' wear of a known colouring may be from another's: lightness, factor of chroma, degrees of hue; its marks half as far.
    private const double LightnessVariety = 0.1;
    private const double ChromaVariety = 0.4;
    private const double HueVariety = 22;

    // Degrees: the hue of tanned leather, and how far towards it the marks of great cats and giraffes turn at most.
    private const double WarmHue = 48;
    private const double WarmTurn = 20;

    private static readonly double[] vividHues = { 25, 45, 70, 110, 145, 175, 200, 230, 260, 290, 330 };
    private static readonly double[] darkHues = { 30, 60, 150, 220, 260, 300 };
    private static readonly double[] accentTurns = { 150, 180, 210, -60, 60 };
    private static readonly double[] irisHues = { 75, 95, 140, 200, 50, 25, 260 };

    /// <summary>The coat of the creature, in the mood that is asked for.</summary>
    public static CoatBlueprint Sample(CreatureBuilder builder, PaletteMood palette)
    {
        RandomStream random = builder.Stream("coat");
        int drawn = random.Weighted(stackalloc double[] { 0.4, 0.33, 0.12, 0.15 });
        PaletteMood mood = palette == PaletteMood.Any ? PaletteMood.Natural + drawn : palette;
        double hue, lightness, chroma;
        switch (mood)
        {
            case PaletteMood.Natural:
                hue = CreatureBuilder.Choose(random, (58.0, 0.35), (75.0, 0.3), (92.0, 0.12), (125.0, 0.06), (42.0, 0.2)) + random.Uniform(-8, 8);
                lightness = random.Uniform(0.48, 0.68);
                chroma = random.Uniform(0.045, 0.10);
                break;
            case PaletteMood.Vivid:
                hue = Pick(random, vividHues) + random.Uniform(-8, 8);
                lightness = random.Uniform(0.52, 0.68);
                chroma = random.Uniform(0.10, 0.15);
                break;
            case PaletteMood.Pale:
                hue = random.Uniform(0, 360);
                lightness = random.Uniform(0.74, 0.82);
                chroma = random.Uniform(0.03, 0.06);
                break;
            default:
                hue = Pick(random, darkHues) + random.Uniform(-10, 10);
                lightness = random.Uniform(0.34, 0.42);
                chroma = random.Uniform(0.04, 0.08);
                break;
        }

        double bellyHue = mood == PaletteMood.Vivid ? hue + ((random.Chance(0.5) ? 1 : -1) * random.Uniform(20, 50)) : hue + ((75 - (((hue + 540) % 360) - 180)) * 0.25);
        double contrast = lightness > 0.5 || random.Chance(0.3) ? -0.27 : 0.25;
        double accentHue = hue + Pick(random, accentTurns);
        ColourBlueprint pattern = Colour(Scalar.Clamp(lightness + contrast, 0.2, 0.92), chroma * random.Uniform(0.7, 1.1), hue + random.Uniform(-25, 25));
        ColourBlueprint accent = Colour(random.Uniform(0.6, 0.74), random.Uniform(0.12, 0.17), accentHue);
        ColourBlueprint limb = random.Chance(0.7) ? Colour(Math.Max(0.22, lightness - 0.16), chroma * 0.8, hue - 8) : Colour(Math.Min(0.85, lightness + 0.1), chroma, hue + 15);
        ColourBlueprint claw = random.Chance(0.6) ? Colour(0.27, 0.02, 60) : Colour(0.82, 0.04, 85);
        ColourBlueprint horn = Colour(random.Uniform(0.35, 0.82), 0.035, 75);
        ColourBlueprint iris = Colour(random.Uniform(0.62, 0.80), random.Uniform(0.10, 0.17), Pick(random, irisHues));
        ColourBlueprint muzzle = builder.Parents.Head.Snout == SnoutKind.Beak
            ? random.Chance(0.65) ? Colour(0.70, 0.13, CreatureBuilder.Choose(random, (60.0, 1), (75.0, 1), (45.0, 1))) : Colour(0.3, 0.02, 60)
            : Colour(0.25, 0.03, 30);
        if (mood != PaletteMood.Vivid && builder.Manes.Exists(mane => mane.IsOfBody))
        {
            // Hair of a colour of its own suits vivid coats; on all others it is a darker or paler shade of the coat.
            accent = Colour(Scalar.Clamp(lightness + (lightness > 0.45 ? -0.24 : 0.2), 0.2, 0.9), chroma * 1.05, hue - 14);
        }

        var coat = new CoatBlueprint(
            Colour(lightness, chroma, hue),
            Colour(Math.Max(0.2, lightness - 0.13), chroma, hue - 12),
            Colour(Math.Min(0.9, lightness + 0.20), chroma * 0.55, bellyHue),
            limb,
            pattern,
            accent,
            claw,
            horn,
            muzzle,
            Colour(0.38, 0.11, 20),
            Tongue(builder, builder.Stream("tongue")),
            iris,
            CreatureBuilder.Choose(random, builder.Parents.Skin.Patterns),
            random.Uniform(0.8, 1.3),
            random.Uniform(0.65, 0.95),
            random.Integer(0, 1 << 16));
        Colouring[] known = builder.Parents.Skin.Colourings;
        RandomStream choice = builder.Stream("colouring");
        CoatBlueprint worn = palette == PaletteMood.Any && known.Length > 0 && choice.Chance(KnownColourings) ? Wear(coat, known[choice.Integer(0, known.Length)], choice) : coat;
        return RareCoats.Perhaps(CoatContrast.On(Darkened(Patterned(worn, builder)), builder.Fitting), palette, builder.Stream("rarity"), builder.Fitting);
    }

    /// <summary>A colour in OKLCH with its hue in degrees, of any number of turns.</summary>
    public static ColourBlueprint Colour(double lightness, double chroma, double hueDegrees) =>
        new(lightness, chroma, Scalar.Radians(((hueDegrees % 360) + 360) % 360));

    private static ColourBlueprint Tongue(CreatureBuilder builder, RandomStream random)
    {
        Tint tint = CreatureBuilder.Choose(random, builder.Parents.Head.TongueTints);
        return Colour(tint.Lightness + random.Uniform(-0.04, 0.04), tint.Chroma * random.Uniform(0.85, 1.15), tint.Hue + random.Uniform(-6, 6));
    }

    /// <summary>The coat in a colouring that its species is known by, varied so that two species of one kind differ.</summary>
    private static CoatBlueprint Wear(CoatBlueprint coat, Colouring known, RandomStream random)
    {
        double lightness = Scalar.Clamp(known.Base.Lightness + random.Uniform(-LightnessVariety, LightnessVariety), 0.16, 0.94);
        double chroma = known.Base.Chroma * random.Uniform(1 - ChromaVariety, 1 + ChromaVariety);
        double hue = known.Base.Hue + random.Uniform(-HueVariety, HueVariety);
        return coat with
        {
            Base = Colour(lightness, chroma, hue),
            Back = Colour(Math.Max(0.16, lightness - 0.12), chroma, hue - 8),
            Belly = Varied(known.Belly) ?? Colour(Math.Min(0.92, lightness + 0.18), chroma * 0.5, hue + 8),
            Limb = Varied(known.Limb) ?? Colour(Math.Max(0.18, lightness - 0.17), chroma * 0.7, hue - 6),
            Pattern = Varied(known.Pattern) ?? Colour(Math.Max(0.17, lightness - 0.26), chroma * 0.8, hue - 10),
            Accent = Varied(known.Accent) ?? (known.KeepsAccent ? coat.Accent : Colour(Math.Max(0.2, lightness - 0.1), chroma * 1.15, hue + 8)),
            Muzzle = Varied(known.Muzzle) ?? coat.Muzzle,
            PatternKind = known.Kind ?? coat.PatternKind,
            PatternScale = coat.PatternScale * known.Scale,
            PatternStrength = known.Kind is null ? coat.PatternStrength : Math.Max(coat.PatternStrength, 0.85),
        };

        ColourBlueprint? Varied(Tint? tint) => tint is not Tint t
            ? null
            : Colour(Scalar.Clamp(t.Lightness + (0.5 * random.Uniform(-LightnessVariety, LightnessVariety)), 0.1, 0.96), t.Chroma, t.Hue + (0.5 * random.Uniform(-HueVariety, HueVariety)));
    }

    /// <summary>A plain coat with a pattern that the animal of the skin or of the head has, where the body is mixed and either has any.</summary>
    private static CoatBlueprint Patterned(CoatBlueprint coat, CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("pattern of the mixture");
        if (coat.PatternKind != PatternKind.Plain || !random.Chance(PatternsOfMixed * builder.Fitting))
        {
            return coat;
        }

        Weighted<PatternKind>[] patterns = builder.Parents.Skin.Patterns.Concat(builder.Parents.Head.Patterns).Where(pattern => pattern.Value != PatternKind.Plain).ToArray();
        return patterns.Length == 0 ? coat : coat with { PatternKind = CreatureBuilder.Choose(random, patterns) };
    }

    /// <summary>Rosettes and plates are always darker than the coat and a little warmer, whatever the colour drawn for them.</summary>
    private static CoatBlueprint Darkened(CoatBlueprint coat)
    {
        if (coat.PatternKind is not (PatternKind.Rosettes or PatternKind.Giraffe))
        {
            return coat;
        }

        double hue = Scalar.Degrees(coat.Pattern.Hue);
        double warmer = Scalar.Clamp(((WarmHue - hue + 540) % 360) - 180, -WarmTurn, WarmTurn);
        double lightness = Math.Min(coat.Pattern.Lightness, Math.Max(0.2, coat.Base.Lightness - 0.31));
        return coat with { Pattern = Colour(lightness, coat.Pattern.Chroma * 1.2, hue + warmer), PatternStrength = Math.Max(coat.PatternStrength, 0.88) };
    }

    private static double Pick(RandomStream random, double[] values) => values[random.Integer(0, values.Length)];
}
