using System.Numerics;
using CreatureGen.Geometry;

namespace CreatureGen.Appearance.Textures;

/// <summary>A corner of a face as the painter of textures needs it. What is mixed between corners lies in fours, so that it is mixed in fours.</summary>
internal struct ChartCorner
{
    /// <summary>Place in the picture, 0..1.</summary>
    public Vector2 Picture;

    /// <summary>The share of the light from all around that comes here, 0..1.</summary>
    public float Openness;

    /// <summary>Region of the surface.</summary>
    public SurfaceRegion Region;

    /// <summary>Rest position, metres at scale 1, and ring of the body.</summary>
    public Vector4 PositionAndRing;

    /// <summary>Metres around and along the chart; segment of the body; radians around the appendage.</summary>
    public Vector4 ChartAndTurns;

    /// <summary>Colour without pattern, linear; metres along the body or down a limb, which stripes count.</summary>
    public Vector4 PlainAndRun;

    /// <summary>Colour with the full pattern, linear; radians around the body, 0 dorsal to π ventral.</summary>
    public Vector4 PatternedAndGirth;

    /// <summary>Colour below the markings without pattern, linear; 0..1 along the appendage.</summary>
    public Vector4 PlainUndercoatAndAlong;

    /// <summary>Colour below the markings with the full pattern, linear; factor on the whole.</summary>
    public Vector4 PatternedUndercoatAndGrain;
}
