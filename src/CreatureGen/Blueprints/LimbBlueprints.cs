using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>A rectangle of cells of the body grid on the left side that a limb grows out of; its mirror image serves the right side.</summary>
/// <param name="Ring">First ring.</param>
/// <param name="Segment">First segment; a midline socket starts at 31 (back) or 15 (belly) and is two cells wide.</param>
/// <param name="Rows">Number of cells along the body, even.</param>
/// <param name="Columns">Number of cells around the body, even.</param>
public sealed record SocketBlueprint(int Ring, int Segment, int Rows, int Columns)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Socket);
}

/// <summary>A pair of legs or arms.</summary>
/// <param name="Archetype">The built form.</param>
/// <param name="Stance">Standing on the ground or hanging.</param>
/// <param name="Socket">Where it grows.</param>
/// <param name="Thickness">Radius of the thigh, metres at scale 1.</param>
/// <param name="Length">Unit of the downward shape, metres at scale 1; a standing leg takes the height of its socket instead.</param>
/// <param name="Reach">Unit of the forward and outward shape, metres at scale 1.</param>
/// <param name="Azimuth">Turn of the outward direction towards the front, radians.</param>
/// <param name="Shear">Forward lean: shift of the foot in units of the length.</param>
/// <param name="Slimness">Factor on the radii below the thigh.</param>
/// <param name="Stoutness">Factor on all radii.</param>
/// <param name="FootSize">Factor on the radii of the foot and on the toes.</param>
/// <param name="KneeRise">Factor on the height of an insect's knee.</param>
/// <param name="Toes">Number of toes or fingers.</param>
/// <param name="ClawLength">Length of the claws in toe radii; 0 for none.</param>
/// <param name="Foot">What it ends in; a pillar's pad and an insect's tip stay as they are.</param>
public sealed record LegBlueprint(
    LimbArchetype Archetype,
    LegStance Stance,
    SocketBlueprint Socket,
    double Thickness,
    double Length,
    double Reach,
    double Azimuth,
    double Shear,
    double Slimness,
    double Stoutness,
    double FootSize,
    double KneeRise,
    int Toes,
    double ClawLength,
    FootStyle Foot = FootStyle.Plain)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Leg);
}

/// <summary>A pair of stitched wings, spread at rest or folded along the flanks.</summary>
/// <param name="Style">Membrane or feathers, or feathers folded.</param>
/// <param name="Socket">Where it grows; of a folded wing its first segment is the height of the upper edge.</param>
/// <param name="Span">Length of one wing, metres at scale 1; of a folded one along the body.</param>
/// <param name="Chord">Greatest depth, metres at scale 1; not used when folded, it follows the body.</param>
/// <param name="Rise">How high the wing is raised, relative to the span; how far it stands off the body when folded.</param>
/// <param name="Sweep">How far the tip lies back, relative to the span; not used when folded.</param>
public sealed record WingBlueprint(WingStyle Style, SocketBlueprint Socket, double Span, double Chord, double Rise, double Sweep)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Wing);
}

/// <summary>A pair of thin insect wings on the back.</summary>
/// <param name="Ring">Ring of the root.</param>
/// <param name="Segment">Segment of the root.</param>
/// <param name="Length">Metres at scale 1.</param>
/// <param name="Width">Metres at scale 1.</param>
/// <param name="Azimuth">Direction in the level plane from straight out to the side, radians; positive forward.</param>
/// <param name="Elevation">Angle above the level plane, radians.</param>
/// <param name="Style">Its outline.</param>
public sealed record InsectWingBlueprint(double Ring, double Segment, double Length, double Width, double Azimuth, double Elevation, ThinWingStyle Style = ThinWingStyle.Blade)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.InsectWing);
}

/// <summary>A fin, single on the midline or a pair on the flanks.</summary>
/// <param name="Place">Where it grows.</param>
/// <param name="Style">Its outline.</param>
/// <param name="Socket">Where it grows.</param>
/// <param name="Length">Height of a midline fin or length of a pectoral one, metres at scale 1.</param>
/// <param name="Width">Depth of a pectoral fin relative to its length; not used on the midline.</param>
/// <param name="Drop">How far a pectoral fin points down for each unit out; not used on the midline.</param>
/// <param name="Sweep">How far the fin lies back for each unit of length.</param>
public sealed record FinBlueprint(FinPlace Place, FinStyle Style, SocketBlueprint Socket, double Length, double Width, double Drop, double Sweep)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Fin);
}

/// <summary>A pair of ears.</summary>
/// <param name="Socket">Where it grows.</param>
/// <param name="Length">Metres at scale 1.</param>
/// <param name="Width">Metres at scale 1.</param>
/// <param name="Outward">Component of its direction to the side.</param>
/// <param name="Upward">Component of its direction up.</param>
/// <param name="Forward">Component of its direction to the front.</param>
/// <param name="Droop">How far the tip hangs, relative to the length.</param>
/// <param name="Roundness">0 for a pointed ear, 1 for a round one.</param>
public sealed record EarBlueprint(SocketBlueprint Socket, double Length, double Width, double Outward, double Upward, double Forward, double Droop, double Roundness)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Ear);
}

/// <summary>A small solid part on the skin: a tapered, curved horn-like body.</summary>
/// <param name="Kind">What it is; decides colour and joint.</param>
/// <param name="Ring">Ring of its root.</param>
/// <param name="Segment">Segment of its root; 0 or 16 makes a single part on the midline, all else a mirrored pair.</param>
/// <param name="Length">Metres at scale 1.</param>
/// <param name="Radius">Radius at the root, metres at scale 1.</param>
/// <param name="Outward">Component of its direction along the skin's normal.</param>
/// <param name="Upward">Component of its direction up.</param>
/// <param name="Forward">Component of its direction to the front.</param>
/// <param name="Sideward">Component of its direction to the side.</param>
/// <param name="BendUp">Displacement of the tip up, in lengths.</param>
/// <param name="BendForward">Displacement of the tip to the front, in lengths.</param>
/// <param name="BendSide">Displacement of the tip to the side, in lengths.</param>
/// <param name="Flatness">Thickness across relative to thickness along the body; of a feeler or a lure, the size of its knob.</param>
/// <param name="Taper">Exponent of the radius along the part: below 1 blunt, 1 a cone.</param>
public sealed record FeatureBlueprint(
    FeatureKind Kind,
    double Ring,
    double Segment,
    double Length,
    double Radius,
    double Outward,
    double Upward,
    double Forward,
    double Sideward,
    double BendUp,
    double BendForward,
    double BendSide,
    double Flatness,
    double Taper)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Feature);
}

/// <summary>The end of the tail.</summary>
/// <param name="Style">Its outline.</param>
/// <param name="Size">Half height of an upright fin or half width of a level one, metres at scale 1; of a tail without either, how far it has its form: 0 as the body tables give it, 1 all.</param>
/// <param name="Fork">Depth of the fork; negative makes a rounded end.</param>
/// <param name="Lobe">How much higher the upper half of an upright fin is than the lower one, as a share of its size; negative when it is lower. Of a fluke, how much its rear edge is the hollow one of a sickle; negative for the full one of a fan.</param>
public sealed record TailBlueprint(TailStyle Style, double Size, double Fork, double Lobe = 0)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LimbFields.Tail);
}
