using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>The face, on the front rings of the body.</summary>
/// <param name="Bumps">Swellings and hollows of the head.</param>
/// <param name="MuzzleSquareness">Exponent of the muzzle's superellipse: 2 round, 3 boxy.</param>
/// <param name="Eyes">Eyes.</param>
/// <param name="Mouth">Mouth.</param>
/// <param name="NostrilSize">Radius of a nostril relative to the half width of the muzzle; 0 for none.</param>
/// <param name="Beak">The horn over its jaws; null for none.</param>
public sealed record HeadBlueprint(ValueList<HeadBump> Bumps, double MuzzleSquareness, EyeBlueprint Eyes, MouthBlueprint Mouth, double NostrilSize, BeakBlueprint? Beak = null)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, HeadFields.Head);
}

/// <summary>A Gaussian swelling of the body's sections, mirrored on both sides.</summary>
/// <param name="Ring">Ring of its centre.</param>
/// <param name="Segment">Segment of its centre, 0 dorsal to 16 ventral.</param>
/// <param name="RingSpread">Standard-like width along the body, rings (the bump is exp(−(d/spread)²)).</param>
/// <param name="SegmentSpread">Width around the body, segments.</param>
/// <param name="Amount">Added to the section's factor; negative for a hollow.</param>
public sealed record HeadBump(double Ring, double Segment, double RingSpread, double SegmentSpread, double Amount)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, HeadFields.Bump);
}

/// <summary>A pair of eyes, or a single eye on the midline.</summary>
/// <param name="Style">How an eye is made.</param>
/// <param name="Ring">Ring of its centre.</param>
/// <param name="Segment">Segment of its centre; 0 for a single eye.</param>
/// <param name="Radius">Metres at scale 1.</param>
/// <param name="Sink">How deep the centre lies below the skin, in radii.</param>
/// <param name="Forward">Share of the head's forward direction in the gaze beside ¾ of the skin's outward direction; 0 looks straight out of the skin.</param>
/// <param name="UpperLid">Opening of the upper lid from the gaze, radians.</param>
/// <param name="LowerLid">Opening of the lower lid from the gaze, radians.</param>
/// <param name="LidTilt">Roll of the lids, radians; positive frowns. Those of a single eye do not roll.</param>
public sealed record EyeBlueprint(EyeStyle Style, double Ring, double Segment, double Radius, double Sink, double Forward, double UpperLid, double LowerLid, double LidTilt)
{
    /// <summary>Whether there is one eye, on the midline. The joints of both are in its place.</summary>
    public bool IsSingle => Segment == 0;

    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, HeadFields.Eyes);
}

/// <summary>The mouth slit.</summary>
/// <param name="CornerRing">Ring of the lip corners; 0 for a head without a mouth slit.</param>
/// <param name="Opening">Angle of the lower jaw at rest, radians.</param>
/// <param name="Smile">Lift of the lip corners, −1..1.</param>
/// <param name="Teeth">Length of the teeth relative to the half width of the muzzle; 0 for none.</param>
/// <param name="Tongue">Form of the tongue.</param>
public sealed record MouthBlueprint(int CornerRing, double Opening, double Smile, double Teeth, TongueStyle Tongue = TongueStyle.None)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, HeadFields.Mouth);
}

/// <summary>A beak: an upper bill on the head and a lower one on the jaw, on a mouth that opens. Both lie on the face, whose sections they follow, and end in a tip of their own.</summary>
/// <param name="Style">Its family.</param>
/// <param name="Length">How far the tip is ahead of the nose, metres at scale 1.</param>
/// <param name="Girth">How far the horn stands off the face, relative to its family's.</param>
/// <param name="Hook">How far it turns down from the nose to its tip, radians.</param>
public sealed record BeakBlueprint(BeakStyle Style, double Length, double Girth, double Hook)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, HeadFields.Beak);
}
