using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>Colours and pattern of the skin.</summary>
/// <param name="Base">Flanks.</param>
/// <param name="Back">Back.</param>
/// <param name="Belly">Belly.</param>
/// <param name="Limb">Lower legs and extremities.</param>
/// <param name="Pattern">Pattern colour.</param>
/// <param name="Accent">Fins, membranes, tufts.</param>
/// <param name="Claw">Claws and hooves.</param>
/// <param name="Horn">Horns and spikes.</param>
/// <param name="Muzzle">Nose, beak or muzzle.</param>
/// <param name="Mouth">Inside of the mouth.</param>
/// <param name="Tongue">Tongue.</param>
/// <param name="Iris">Eyes.</param>
/// <param name="PatternKind">Pattern.</param>
/// <param name="PatternScale">Frequency of the pattern.</param>
/// <param name="PatternStrength">0..1.</param>
/// <param name="PatternSeed">Chooses among patterns of one kind, and where colours go.</param>
/// <param name="Marks">Where the marks of the pattern lie: the fingerprint by which one individual is told from another.</param>
public sealed record CoatBlueprint(
    ColourBlueprint Base,
    ColourBlueprint Back,
    ColourBlueprint Belly,
    ColourBlueprint Limb,
    ColourBlueprint Pattern,
    ColourBlueprint Accent,
    ColourBlueprint Claw,
    ColourBlueprint Horn,
    ColourBlueprint Muzzle,
    ColourBlueprint Mouth,
    ColourBlueprint Tongue,
    ColourBlueprint Iris,
    PatternKind PatternKind,
    double PatternScale,
    double PatternStrength,
    int PatternSeed,
    int Marks = 0)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, CoatFields.Coat);
}

/// <summary>A colour in OKLCH.</summary>
/// <param name="Lightness">0 black to 1 white.</param>
/// <param name="Chroma">0 grey to about 0.3.</param>
/// <param name="Hue">Radians: about 0.5 red, 1.9 yellow, 2.5 green, 4.6 blue.</param>
public sealed record ColourBlueprint(double Lightness, double Chroma, double Hue)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, CoatFields.Colour);
}
