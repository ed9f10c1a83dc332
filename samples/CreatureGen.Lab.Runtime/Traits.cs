using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Lab.Runtime;

/// <summary>Something of a creature that a slider changes.</summary>
/// <param name="Name">What the page calls it.</param>
/// <param name="Min">Left end.</param>
/// <param name="Max">Right end.</param>
/// <param name="Own">Where the creature is as it was grown.</param>
/// <param name="Applies">Whether it changes anything of this creature.</param>
/// <param name="Change">The changed creature.</param>
internal sealed record Trait(string Name, double Min, double Max, double Own, Predicate<CreatureBlueprint> Applies, Func<CreatureBlueprint, double, CreatureBlueprint> Change);

/// <summary>The sliders. All but colour are factors on the creature's own numbers; ends are those at which creatures of all kinds were built and inspected.</summary>
internal static class Traits
{
    public static readonly IReadOnlyList<Trait> All =
    [
        Factor("size", 0.4, 2.5, Always, (b, v) => b with { Scale = b.Scale * v }),
        Factor("girth", 0.6, 1.7, Always, (b, v) => Shape(b, p => p with { Girth = p.Girth * v, Belly = p.Belly * Math.Sqrt(v) })),
        Factor("neck", 0.4, 2.4, Always, (b, v) => Shape(b, p => p with { Neck = p.Neck * v, NeckGirth = p.NeckGirth * Math.Pow(v, -0.25) })),
        Factor("head", 0.6, 1.6, Always, (b, v) => Shape(b, p => p with { Head = p.Head * v })),
        Factor("snout", 0.5, 2, Always, (b, v) => Shape(b, p => p with { Snout = p.Snout * v })),
        Factor("eyes", 0.6, 1.6, Always, (b, v) => b with { Head = b.Head with { Eyes = b.Head.Eyes with { Radius = b.Head.Eyes.Radius * v } } }),
        Factor("legs", 0.55, 1.8, b => b.Legs.Any(leg => !IsArm(leg)), (b, v) => b with { Legs = Each(b.Legs, leg => IsArm(leg) ? leg : Longer(leg, v)) }),
        Factor("arms", 0.55, 1.8, b => b.Legs.Any(IsArm), (b, v) => b with { Legs = Each(b.Legs, leg => IsArm(leg) ? Longer(leg, v) : leg) }),
        Factor("stoutness", 0.6, 1.7, b => b.Legs.Count > 0, (b, v) => b with { Legs = Each(b.Legs, leg => leg with { Stoutness = leg.Stoutness * v, FootSize = leg.FootSize * Math.Sqrt(v) }) }),
        Factor("tail", 0.35, 2.4, Always, (b, v) => Shape(b, p => p with { Tail = p.Tail * v, TailGirth = p.TailGirth * Math.Pow(v, -0.2) })),
        Factor("wings", 0.5, 1.8, b => b.Wings.Count + b.InsectWings.Count + b.Fins.Count > 0, Wings),
        Factor("ornaments", 0.3, 2.2, b => b.Features.Count + b.Ears.Count + b.Frills.Count + b.Manes.Count > 0, Ornaments),
        Factor("pattern", 0, 2, b => b.Coat.PatternStrength > 0, (b, v) => b with { Coat = b.Coat with { PatternStrength = Math.Min(1, b.Coat.PatternStrength * v) } }),
        new("colour", -Math.PI, Math.PI, 0, Always, Colour),
    ];

    private static Trait Factor(string name, double least, double most, Predicate<CreatureBlueprint> applies, Func<CreatureBlueprint, double, CreatureBlueprint> change) => new(name, least, most, 1, applies, change);

    /// <summary>Whether it grasps: an arm with a hand, or a mantis's.</summary>
    private static bool IsArm(LegBlueprint leg) => leg.Archetype is LimbArchetype.Arm or LimbArchetype.Raptorial;

    private static LegBlueprint Longer(LegBlueprint leg, double v) => leg with { Length = leg.Length * v, Reach = leg.Reach * v };

    private static bool Always(CreatureBlueprint blueprint) => true;

    private static CreatureBlueprint Shape(CreatureBlueprint b, Func<BodyProportions, BodyProportions> change) => b with { Body = b.Body with { Proportions = change(b.Body.Proportions) } };

    private static CreatureBlueprint Wings(CreatureBlueprint b, double v) => b with
    {
        Wings = Each(b.Wings, wing => wing with { Span = wing.Span * v, Chord = wing.Chord * Math.Sqrt(v) }),
        InsectWings = Each(b.InsectWings, wing => wing with { Length = wing.Length * v, Width = wing.Width * Math.Sqrt(v) }),
        Fins = Each(b.Fins, fin => fin with { Length = fin.Length * v }),
    };

    private static CreatureBlueprint Ornaments(CreatureBlueprint b, double v) => b with
    {
        Features = Each(b.Features, part => part with { Length = part.Length * v, Radius = part.Radius * Math.Sqrt(v) }),
        Ears = Each(b.Ears, ear => ear with { Length = ear.Length * v }),
        Frills = Each(b.Frills, frill => frill with { Length = frill.Length * Math.Sqrt(v) }),
        Manes = Each(b.Manes, mane => mane with { Length = mane.Length * Math.Sqrt(v) }),
    };

    /// <summary>Turns the hues of the coat; eyes, claws, horns and mouth keep theirs.</summary>
    private static CreatureBlueprint Colour(CreatureBlueprint b, double turn)
    {
        ColourBlueprint Turn(ColourBlueprint colour) => colour with { Hue = Math.IEEERemainder(colour.Hue + turn, 2 * Math.PI) };
        CoatBlueprint c = b.Coat;
        return b with { Coat = c with { Base = Turn(c.Base), Back = Turn(c.Back), Belly = Turn(c.Belly), Limb = Turn(c.Limb), Pattern = Turn(c.Pattern), Accent = Turn(c.Accent) } };
    }

    private static ValueList<T> Each<T>(ValueList<T> items, Func<T, T> change)
        where T : IEquatable<T> => new(items.Select(change));
}
