using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>A corner of a face, or a place between corners, as the painter of textures needs it.</summary>
internal struct TexelPlace
{
    /// <summary>Rest position, metres at scale 1.</summary>
    public Vector3 Position;

    /// <summary>Smooth normal; between corners not of unit length.</summary>
    public Vector3 Normal;

    /// <summary>Metres around and along the chart.</summary>
    public Vector2 Chart;

    /// <summary>Ring of the body.</summary>
    public float Ring;

    /// <summary>Segment of the body.</summary>
    public float Segment;

    /// <summary>0..1 along the appendage.</summary>
    public float Along;

    /// <summary>Radians around the appendage.</summary>
    public float Around;

    /// <summary>Colour without pattern, linear.</summary>
    public Vector3 Plain;

    /// <summary>Colour with the full pattern, linear.</summary>
    public Vector3 Patterned;

    /// <summary>Metres along the body or down a limb, which stripes count.</summary>
    public float Run;

    /// <summary>Radians around the body, 0 dorsal to π ventral.</summary>
    public float Girth;

    /// <summary>The place at the given weights of three corners.</summary>
    public static TexelPlace Between(in TexelPlace a, in TexelPlace b, in TexelPlace c, float wa, float wb, float wc) => new()
    {
        Position = (a.Position * wa) + (b.Position * wb) + (c.Position * wc),
        Normal = (a.Normal * wa) + (b.Normal * wb) + (c.Normal * wc),
        Chart = (a.Chart * wa) + (b.Chart * wb) + (c.Chart * wc),
        Ring = (a.Ring * wa) + (b.Ring * wb) + (c.Ring * wc),
        Segment = (a.Segment * wa) + (b.Segment * wb) + (c.Segment * wc),
        Along = (a.Along * wa) + (b.Along * wb) + (c.Along * wc),
        Around = (a.Around * wa) + (b.Around * wb) + (c.Around * wc),
        Plain = (a.Plain * wa) + (b.Plain * wb) + (c.Plain * wc),
        Patterned = (a.Patterned * wa) + (b.Patterned * wb) + (c.Patterned * wc),
        Run = (a.Run * wa) + (b.Run * wb) + (c.Run * wc),
        Girth = (a.Girth * wa) + (b.Girth * wb) + (c.Girth * wc),
    };

    /// <summary>The address of the place in a region of the surface, on the left side.</summary>
    public readonly VertexAddress Address(SurfaceRegion region, short appendage) => new()
    {
        Region = region,
        Appendage = appendage,
        Sign = 1,
        Along = Along,
        Around = Around,
        Ring = Ring,
        Segment = Segment,
    };

    /// <summary>The unit normal.</summary>
    public readonly Vector3 UnitNormal => Vec.Normalize(Normal, Vector3.UnitY);
}
