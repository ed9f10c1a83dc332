using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Features;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Individuals;

/// <summary>From the blueprint of a species' type to that of an individual: all choices stay, numbers vary.</summary>
internal static class IndividualSampler
{
    /// <summary>First and last ring that a folded wing lies along.</summary>
    private const int FoldFrom = 25, FoldTo = 46;

    /// <summary>Rings before this one belong to the head.</summary>
    private const int HeadEnd = 16;

    /// <summary>The individual.</summary>
    /// <param name="type">The blueprint of the type.</param>
    /// <param name="ofType">What it was made from.</param>
    /// <param name="traits">The individual's traits.</param>
    /// <param name="options">Limits of its size.</param>
    public static CreatureBlueprint Vary(CreatureBlueprint type, CreatureBuilder ofType, IndividualTraits traits, CreatureOptions options)
    {
        IndividualBody body = IndividualBody.Of(type, ofType, traits);
        CreatureBuilder builder = body.Builder;
        BodyShape was = ofType.Shape;
        double skull = builder.Shape.Width[StationRing.Cranium] / was.Width[StationRing.Cranium];
        double girth = builder.HalfDepth(StationRing.NeckMiddle) / ofType.HalfDepth(StationRing.NeckMiddle);
        double side = (builder.Shape.Arc[FoldTo] - builder.Shape.Arc[FoldFrom]) / (was.Arc[FoldTo] - was.Arc[FoldFrom]);
        var individual = type with
        {
            Scale = Scalar.Clamp(type.Scale * traits.Size, options.MinScale, options.MaxScale),
            Body = type.Body with { Proportions = builder.Proportions, Posture = builder.Posture, Elevation = builder.Elevation },
            Head = Face(type.Head, ofType, builder, traits),
            Tail = type.Tail with { Size = type.Tail.Size * traits.Fins },
            Legs = new ValueList<LegBlueprint>(body.Legs),
            Wings = type.Wings.Each(wing => Wing(wing, traits, side)),
            InsectWings = type.InsectWings.Each(wing => wing with { Length = wing.Length * traits.Wings, Width = wing.Width * traits.Wings }),
            Fins = type.Fins.Each(fin => fin with { Length = fin.Length * traits.Fins }),
            Ears = type.Ears.Each(ear => ear with { Length = ear.Length * skull * traits.Ears, Width = ear.Width * skull }),
            Features = type.Features.Each(part => FeatureSampler.OffGround(builder, Part(part, traits, part.Ring < HeadEnd ? skull : 1))),
            Manes = type.Manes.Each(mane => NeckSampler.OffGround(builder, Mane(mane, traits, girth))),
            Frills = type.Frills.Each(frill => NeckSampler.OffGround(builder, frill with { Length = frill.Length * skull * Math.Sqrt(traits.Horns), Thickness = frill.Thickness * skull })),
            Coat = Coat(type.Coat, traits),
        };
        return FieldLimiter.Limit(individual, CreatureFields.Creature);
    }

    private static HeadBlueprint Face(HeadBlueprint head, CreatureBuilder ofType, CreatureBuilder builder, IndividualTraits traits)
    {
        double half = HeadSampler.HalfHeight(builder.Shape) / HeadSampler.HalfHeight(ofType.Shape);
        double radius = Math.Min(head.Eyes.Radius * half * traits.Eyes, Math.Max(head.Eyes.Radius * half, HeadSampler.LargestEye(builder)));
        double lid = Scalar.Radians(Scalar.Clamp(traits.Seed.Child("lids").Stream().Normal(0, 2), -4, 4));
        return head with
        {
            Bumps = head.Bumps.Each(bump => bump with { Amount = bump.Amount * traits.Bones }),
            Eyes = head.Eyes with { Radius = radius, UpperLid = head.Eyes.UpperLid + lid },
            Mouth = head.Mouth with { Opening = Math.Min(head.Mouth.Opening, HeadSampler.WidestOpening(builder)), Teeth = head.Mouth.Teeth * traits.Claws },
            Beak = head.Beak is BeakBlueprint beak ? beak with { Length = BeakSampler.OffGround(builder, beak.Length * half * traits.Claws, beak.Hook) } : null,
        };
    }

    private static WingBlueprint Wing(WingBlueprint wing, IndividualTraits traits, double side) => wing.Style == WingStyle.Folded
        ? wing with { Span = wing.Span * side, Rise = wing.Rise / side }
        : wing with { Span = wing.Span * traits.Wings, Chord = wing.Chord * traits.Wings };

    /// <summary>Horns, antlers and tusks grow with age.</summary>
    private static FeatureBlueprint Part(FeatureBlueprint part, IndividualTraits traits, double skull)
    {
        double growth = part.Kind is FeatureKind.Horn or FeatureKind.Antler or FeatureKind.Tusk ? traits.Horns : traits.Parts;
        return part with { Length = part.Length * skull * growth, Radius = part.Radius * skull * Math.Sqrt(growth) };
    }

    /// <summary>Manes grow with age.</summary>
    private static ManeBlueprint Mane(ManeBlueprint mane, IndividualTraits traits, double girth) =>
        mane with { Length = mane.Length * girth * Math.Sqrt(traits.Horns), Width = mane.Width * girth };

    /// <summary>One shift of hue, lightness and chroma for the whole coat, so that it stays in harmony; and marks of its own.</summary>
    private static CoatBlueprint Coat(CoatBlueprint coat, IndividualTraits traits)
    {
        RandomStream random = traits.Seed.Child("coat").Stream();
        double hue = Scalar.Radians(Scalar.Clamp(random.Normal(0, 4), -9, 9));
        double lightness = Scalar.Clamp(random.Normal(0, 0.022), -0.05, 0.05) + (0.03 * traits.Youth);
        double chroma = random.LogNormal(0.08, 0.8, 1.2) * (1 - (0.15 * traits.Youth));
        double iris = Scalar.Radians(Scalar.Clamp(random.Normal(0, 5), -10, 10));
        return coat with
        {
            Base = Shift(coat.Base),
            Back = Shift(coat.Back),
            Belly = Shift(coat.Belly),
            Limb = Shift(coat.Limb),
            Pattern = Shift(coat.Pattern),
            Accent = Shift(coat.Accent),
            Muzzle = Shift(coat.Muzzle),
            Iris = coat.Iris with { Hue = Turned(coat.Iris.Hue, iris) },
            PatternScale = coat.PatternScale * random.LogNormal(0.07, 0.85, 1.18),
            PatternStrength = Scalar.Clamp(coat.PatternStrength * random.LogNormal(0.06, 0.85, 1.15), 0, 1),
            Marks = random.Integer(1, 1 << 16),
        };

        ColourBlueprint Shift(ColourBlueprint colour) => new(Scalar.Clamp(colour.Lightness + lightness, 0.1, 0.95), colour.Chroma * chroma, Turned(colour.Hue, hue));
    }

    /// <summary>A hue turned either way by less than a full turn, within 0 and 2π again.</summary>
    private static double Turned(double hue, double by)
    {
        double turned = hue + by;
        return turned < 0 ? turned + PortableMath.Tau : turned > PortableMath.Tau ? turned - PortableMath.Tau : turned;
    }
}
