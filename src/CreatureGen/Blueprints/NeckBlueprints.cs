using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>Hair in locks on a field of the body: a mane, a crest of bristles, a beard, the tuft of a tail.</summary>
/// <param name="Ring">Ring of its first row of locks.</param>
/// <param name="LastRing">Ring of its last row; not below <paramref name="Ring"/>.</param>
/// <param name="Segment">Segment of the highest locks, 0 on the back.</param>
/// <param name="LastSegment">Segment of the lowest locks, 16 on the belly; not below <paramref name="Segment"/>. Locks at 0 and 16 are single, all others pairs.</param>
/// <param name="Rows">Rows along the body; every other is shifted by half a lock.</param>
/// <param name="Columns">Locks of a row on one side.</param>
/// <param name="Length">Length of a lock of the first row, metres at scale 1.</param>
/// <param name="Growth">Length of the last row's locks relative to that of the first row's.</param>
/// <param name="Width">Half width of a lock, metres at scale 1.</param>
/// <param name="Rise">Angle at which locks leave the skin, radians.</param>
/// <param name="Fall">Direction on the skin, radians: 0 towards the tail, a right angle down the flank, two to the front.</param>
/// <param name="Hang">How far locks under the body hang down, in lengths.</param>
public sealed record ManeBlueprint(
    double Ring,
    double LastRing,
    double Segment,
    double LastSegment,
    int Rows,
    int Columns,
    double Length,
    double Growth,
    double Width,
    double Rise,
    double Fall,
    double Hang)
{
    /// <summary>Whether it grows ahead of the tail.</summary>
    internal bool IsOfBody => Ring < StationRing.TorsoLast;

    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, NeckFields.Mane);
}

/// <summary>A collar that stands off the back of the head on both sides.</summary>
/// <param name="Ring">Ring that it stands on.</param>
/// <param name="Spread">Segment down to which it reaches on either side.</param>
/// <param name="Length">From the skin to the rim over the back, metres at scale 1.</param>
/// <param name="Tilt">How far it lies back, radians; 0 stands straight off the head.</param>
/// <param name="Bend">How far the rim bends back, in lengths; negative bends it forward.</param>
/// <param name="Thickness">Metres at scale 1.</param>
/// <param name="Points">Scallops of the rim on one side.</param>
/// <param name="Scallop">Depth of the notches between them, in lengths.</param>
public sealed record FrillBlueprint(double Ring, double Spread, double Length, double Tilt, double Bend, double Thickness, int Points, double Scallop)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, NeckFields.Frill);
}
