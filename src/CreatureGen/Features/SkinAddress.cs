using CreatureGen.Anatomy;

namespace CreatureGen.Features;

/// <summary>The place of the body's grid whose motion a vertex shares.</summary>
internal readonly struct SkinAddress
{
    public SkinAddress(int ring, int segment)
    {
        Ring = ring;
        Segment = segment;
    }

    public int Ring { get; }

    /// <summary>0..31.</summary>
    public int Segment { get; }

    /// <summary>The same place on the other side.</summary>
    public SkinAddress Mirrored => new(Ring, BodyGrid.MirrorSegment(Segment));
}
