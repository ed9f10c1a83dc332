using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics;

/// <summary>Changes a blueprint at random by one strength: at little strength its proportions and hue, at much also its pattern and its limbs.</summary>
public static class Mutation
{
    /// <summary>Spreads at strength 1: of the logarithm of a size, of that of a slice of the body, of angles in radians, of the hue in radians.</summary>
    private const double SizeSpread = 0.28;
    private const double SliceSpread = 0.12;
    private const double AngleSpread = 0.16;
    private const double HueSpread = 0.6;

    /// <summary>Probability of another number of limbs at strength 1.</summary>
    private const double LimbOdds = 0.3;

    /// <summary>The mutant of a valid blueprint, before repair.</summary>
    /// <param name="blueprint">What is changed.</param>
    /// <param name="strength">0..1; 0 changes nothing.</param>
    /// <param name="seed">Which of its mutants.</param>
    /// <exception cref="ArgumentOutOfRangeException">The strength is not in 0..1.</exception>
    public static CreatureBlueprint Mutate(CreatureBlueprint blueprint, double strength, Seed seed)
    {
        if (!(strength >= 0 && strength <= 1))
        {
            throw new ArgumentOutOfRangeException(nameof(strength), strength, "expected 0..1");
        }

        if (strength == 0)
        {
            return blueprint;
        }

        // The upper half of the range is for those who want to be surprised.
        double m = strength * (1 + strength);
        RandomStream random = seed.Child("numbers").Stream();
        BodyBlueprint body = blueprint.Body;
        double Size(double value) => random.Chance(0.5) ? value * random.LogNormal(SizeSpread * m, 0.4, 2.5) : value;
        double Slice(double value) => random.Chance(0.5) ? value * random.LogNormal(SliceSpread * m, 0.6, 1.7) : value;
        double Angle(double value) => random.Chance(0.5) ? value + random.Normal(0, AngleSpread * m) : value;
        BodyProportions p = body.Proportions;
        BodyPosture posture = body.Posture;
        CreatureBlueprint mutant = blueprint with
        {
            Scale = Size(blueprint.Scale),
            Body = body with
            {
                Proportions = new BodyProportions(Size(p.Head), Size(p.Snout), Size(p.Neck), Size(p.NeckGirth), Size(p.Girth), Size(p.Belly), Size(p.Chest), Size(p.Hump), Size(p.Rump), Size(p.Tail), Size(p.TailGirth), Slice(p.Depth), Slice(p.Width)),
                Posture = posture with { Head = Angle(posture.Head), Neck = Angle(posture.Neck), Tail = Angle(posture.Tail), NeckBend = posture.NeckBend + (0.2 * (Angle(0) - 0)), TailBend = posture.TailBend + (0.1 * Angle(0)) },
                Slices = body.Slices.Each(slice => new LatticeSlice(Slice(slice.Width), Slice(slice.Height), Slice(slice.Length))),
            },
            Head = blueprint.Head with { Bumps = blueprint.Head.Bumps.Each(bump => bump with { Amount = bump.Amount > 0 ? Size(bump.Amount) : bump.Amount }) },
            Tail = blueprint.Tail with { Size = Size(blueprint.Tail.Size) },
            Legs = blueprint.Legs.Each(leg => leg with { Thickness = Slice(leg.Thickness), Stoutness = Slice(leg.Stoutness), Slimness = Slice(leg.Slimness), FootSize = Slice(leg.FootSize) }),
            Wings = blueprint.Wings.Each(wing => wing with { Span = Size(wing.Span), Chord = Slice(wing.Chord), Sweep = Angle(wing.Sweep) }),
            InsectWings = blueprint.InsectWings.Each(wing => wing with { Length = Size(wing.Length), Width = Size(wing.Width) }),
            Fins = blueprint.Fins.Each(fin => fin with { Length = Size(fin.Length), Sweep = Angle(fin.Sweep) }),
            Ears = blueprint.Ears.Each(ear => ear with { Length = Size(ear.Length), Width = Size(ear.Width), Droop = Angle(ear.Droop) }),
            Features = blueprint.Features.Each(part => part with { Length = Size(part.Length) }),
            Manes = blueprint.Manes.Each(mane => mane with { Length = Size(mane.Length) }),
            Frills = blueprint.Frills.Each(frill => frill with { Length = Size(frill.Length), Tilt = Angle(frill.Tilt) }),
            Coat = Recoloured(blueprint.Coat, m, seed.Child("coat").Stream()),
        };
        mutant = WithOtherBeak(mutant, m, seed.Child("beak").Stream());
        RandomStream limbs = seed.Child("limbs").Stream();
        return FieldLimiter.Limit(limbs.Chance(LimbOdds * strength) ? WithOtherLegs(mutant, limbs) : mutant, CreatureFields.Creature);
    }

    private static CreatureBlueprint WithOtherBeak(CreatureBlueprint blueprint, double m, RandomStream random) => blueprint.Head.Beak is BeakBlueprint beak
        ? blueprint with { Head = blueprint.Head with { Beak = beak with { Length = beak.Length * random.LogNormal(SizeSpread * m, 0.4, 2.5), Hook = beak.Hook + random.Normal(0, AngleSpread * m) } } }
        : blueprint;

    /// <summary>Turns the whole palette, so that its colours stay of one mood, and draws the pattern anew now and then.</summary>
    private static CoatBlueprint Recoloured(CoatBlueprint coat, double m, RandomStream random)
    {
        double turn = random.Normal(0, HueSpread * m);
        double chroma = random.LogNormal(0.2 * m, 0.5, 2);
        double lighter = random.Normal(0, 0.05 * m);
        ColourBlueprint Turned(ColourBlueprint colour) => new(colour.Lightness + lighter, colour.Chroma * chroma, Wrap(colour.Hue + turn));
        return coat with
        {
            Base = Turned(coat.Base),
            Back = Turned(coat.Back),
            Belly = Turned(coat.Belly),
            Limb = Turned(coat.Limb),
            Pattern = Turned(coat.Pattern),
            Accent = Turned(coat.Accent),
            PatternScale = coat.PatternScale * random.LogNormal(SizeSpread * m, 0.5, 2),
            PatternSeed = random.Chance(Math.Min(1, m)) ? random.Integer(0, int.MaxValue) : coat.PatternSeed,
        };
    }

    private static double Wrap(double hue) => hue > 2 * PortableMath.Pi ? hue - (2 * PortableMath.Pi) : hue < -2 * PortableMath.Pi ? hue + (2 * PortableMath.Pi) : hue;

    /// <summary>One more pair of splayed legs behind the last, or one pair less where the plan can spare it. Legs under a body stay as many: its gait is made for them.</summary>
    private static CreatureBlueprint WithOtherLegs(CreatureBlueprint blueprint, RandomStream random)
    {
        int last = blueprint.Legs.Count - 1;
        if (last < 0 || !LegKinds.Of(blueprint.Legs[last].Archetype).Outline.Lateral || blueprint.Legs.Count == CreatureFields.MaxLegs)
        {
            return blueprint;
        }

        var legs = new List<LegBlueprint>(blueprint.Legs);
        LegBlueprint leg = legs[last];
        if (random.Chance(0.6))
        {
            legs.Add(leg with { Socket = leg.Socket with { Ring = leg.Socket.Ring + leg.Socket.Rows + 1 } });
        }
        else if (PlanNeeds.StandingLegs(blueprint) > PlanNeeds.Of(blueprint).Need)
        {
            legs.RemoveAt(last);
        }

        return blueprint with { Legs = new ValueList<LegBlueprint>(legs) };
    }
}
