using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>What a game asks of the creatures that seeds give. Immutable; change a copy with a <c>with</c> expression.</summary>
/// <remarks>The defaults ask for nothing in particular. The same seed and options always give the same creature.</remarks>
public sealed record CreatureOptions
{
    /// <summary>The defaults.</summary>
    public static CreatureOptions Default { get; } = new();

    /// <summary>How the creature moves. Default: <see cref="RequestedKind.Any"/>.</summary>
    public RequestedKind Kind { get; init; } = RequestedKind.Any;

    /// <summary>
    /// Least size of the whole creature, 0.05..20; at 1 a torso is about one metre long. What lies between it and <see cref="MaxScale"/> is shared out by how large a creature's parents are in life:
    /// rhinos are near the greatest size, ants two fifths of the way up to it from the least, by logarithms; strange ones may be smaller. Default: 0.5.
    /// </summary>
    public double MinScale { get; init; } = 0.5;

    /// <summary>Greatest size of the whole creature, 0.05..20, not below <see cref="MinScale"/>. Default: 2.</summary>
    public double MaxScale { get; init; } = 2;

    /// <summary>Least number of pairs of legs and arms, 0..16. Default: 0.</summary>
    public int MinLegPairs { get; init; }

    /// <summary>Greatest number of pairs of legs and arms, 0..16, not below <see cref="MinLegPairs"/>. Default: 16.</summary>
    public int MaxLegPairs { get; init; } = 16;

    /// <summary>Factors on how often body plans are drawn; a plan that is not in the list has 1. Each plan at most once. Default: none.</summary>
    public ValueList<BodyPlanWeight> BodyPlans { get; init; } = ValueList<BodyPlanWeight>.Empty;

    /// <summary>Factors on how often base bodies are drawn; one that is not in the list has 1. Each name at most once. Default: none.</summary>
    public ValueList<BaseBodyWeight> BaseBodies { get; init; } = ValueList<BaseBodyWeight>.Empty;

    /// <summary>
    /// How far creatures may be from any animal, 0..1. At 0 they are animals; with more of it torso, head, tail, legs, skin, ornaments, wings and fins come from any three
    /// bodies. A mix that would not stand, or has no room for its limbs, is drawn again with less of it, the same way for the same seed. Default: 0.6.
    /// </summary>
    public double Strangeness { get; init; } = 0.6;

    /// <summary>Mood of the colours. Default: <see cref="PaletteMood.Any"/>.</summary>
    public PaletteMood Palette { get; init; } = PaletteMood.Any;

    /// <summary>How much sits on the skin. Default: <see cref="OrnamentLevel.Normal"/>.</summary>
    public OrnamentLevel Ornaments { get; init; } = OrnamentLevel.Normal;

    /// <summary>Triangles that the creature may have at the finest level of detail, 6000..100000. Default: 20000.</summary>
    public int TriangleBudget { get; init; } = 20000;

    /// <summary>
    /// Which individual of the seed's species: all share plan, body, ornaments and palette, and differ in size, age, proportions and marks. Any value will do.
    /// Default: null, the type specimen of the species.
    /// </summary>
    public ulong? Individual { get; init; }

    /// <summary>All problems of these options: fields out of range, and fields that contradict one another. Empty for good ones.</summary>
    public IReadOnlyList<Problem> Validate() => OptionsRules.Validate(this);

    /// <summary>Passes good options.</summary>
    /// <exception cref="ArgumentException">The options are not valid; the message tells all problems, each on a line of its own.</exception>
    public void ThrowIfInvalid() => RecordJson.ThrowIfAny(Validate(), "the options are not valid", "options");

    /// <summary>Their JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, OptionsFields.Options);
}
