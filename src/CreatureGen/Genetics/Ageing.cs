using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Repairs;

namespace CreatureGen.Genetics;

/// <summary>Shows a creature younger than it is: babies are small, with large heads and eyes, short snouts and limbs, soft ornaments and pale colours.</summary>
/// <remarks>Source of the proportions: K. Lorenz, "Die angeborenen Formen möglicher Erfahrung", Z. Tierpsychol. 5 (1943), the scheme of babies.</remarks>
public static class Ageing
{
    /// <summary>Size of a baby relative to the grown creature.</summary>
    private const double BabySize = 0.4;

    /// <summary>The same creature at an age, made to stand again.</summary>
    /// <param name="adult">The grown creature's blueprint.</param>
    /// <param name="age">0 just born .. 1 grown, which is the blueprint as it is.</param>
    /// <exception cref="ArgumentException">The blueprint is not valid.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The age is not in 0..1.</exception>
    public static RepairReport At(CreatureBlueprint adult, double age)
    {
        BlueprintValidator.ThrowIfInvalid(adult);
        if (!(age >= 0 && age <= 1))
        {
            throw new ArgumentOutOfRangeException(nameof(age), age, "expected 0..1");
        }

        return BlueprintRepair.Repair(age == 1 ? adult : Young(adult, 1 - age));
    }

    /// <summary>The blueprint of a young one.</summary>
    /// <param name="b">The grown creature.</param>
    /// <param name="y">How young, 0 grown .. 1 just born.</param>
    private static CreatureBlueprint Young(CreatureBlueprint b, double y)
    {
        double By(double part) => 1 + (part * y);
        BodyProportions p = b.Body.Proportions;
        CreatureBlueprint young = b with
        {
            Scale = b.Scale * By(BabySize - 1),
            Body = b.Body with
            {
                Proportions = p with { Head = p.Head * By(0.45), Snout = p.Snout * By(-0.3), Neck = p.Neck * By(-0.25), NeckGirth = p.NeckGirth * By(0.1), Chest = p.Chest * By(-0.08), Hump = p.Hump * By(-0.1), Belly = p.Belly * By(0.1), Tail = p.Tail * By(-0.25) },
                Elevation = b.Kind == LocomotionKind.Walking ? b.Body.Elevation * By(-0.12) : b.Body.Elevation,
            },
            Head = b.Head with
            {
                Eyes = b.Head.Eyes with { Radius = b.Head.Eyes.Radius * By(0.3) },
                Mouth = b.Head.Mouth with { Teeth = y > 0.5 ? 0 : b.Head.Mouth.Teeth },
                Beak = b.Head.Beak is BeakBlueprint beak ? beak with { Length = beak.Length * By(-0.3) } : null,
            },
            Tail = b.Tail with { Size = b.Tail.Size * By(-0.3) },
            Legs = b.Legs.Each(leg => leg with { Length = leg.Length * By(-0.12), Stoutness = leg.Stoutness * By(0.15), FootSize = leg.FootSize * By(0.15), ClawLength = leg.ClawLength * By(-0.6) }),
            Wings = b.Wings.Each(wing => wing with { Span = wing.Span * By(-0.35), Chord = wing.Chord * By(-0.2) }),
            InsectWings = b.InsectWings.Each(wing => wing with { Length = wing.Length * By(-0.4), Width = wing.Width * By(-0.3) }),
            Fins = b.Fins.Each(fin => fin with { Length = fin.Length * By(-0.25) }),
            Features = b.Features.Each(part => part with { Length = part.Length * By(part.Kind is FeatureKind.Antenna or FeatureKind.Mandible or FeatureKind.Tuft or FeatureKind.Ocellus or FeatureKind.Lure ? -0.2 : -0.7), Radius = part.Radius * By(-0.15) }),
            Manes = b.Manes.Each(mane => mane with { Length = mane.Length * By(-0.55) }),
            Frills = b.Frills.Each(frill => frill with { Length = frill.Length * By(-0.5) }),
            Coat = b.Coat with { Base = Paler(b.Coat.Base, y), Back = Paler(b.Coat.Back, y), Limb = Paler(b.Coat.Limb, y), Pattern = Paler(b.Coat.Pattern, y), Accent = Paler(b.Coat.Accent, y) },
        };
        return FieldLimiter.Limit(young, CreatureFields.Creature);
    }

    private static ColourBlueprint Paler(ColourBlueprint colour, double y) => colour with { Lightness = colour.Lightness + (0.25 * y * (0.75 - colour.Lightness)), Chroma = colour.Chroma * (1 - (0.25 * y)) };
}
