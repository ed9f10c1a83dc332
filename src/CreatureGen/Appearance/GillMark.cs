using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What is seen of the gills of a fish.</summary>
internal enum GillMark
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The rear edge of a cover behind the cheek.</summary>
    Cover,

    /// <summary>Five slits on the flank, as sharks have them.</summary>
    Slits,

    /// <summary>Five short slits beside the midline above and below, on a disc.</summary>
    DiscSlits,
}

/// <summary>Where gills are painted.</summary>
internal static class GillMarks
{
    // All of it is where the coat of a head is painted finer than the mesh. The edge of a cover: its rear-most ring, how far it draws forward above and below, where its middle is and how far it reaches, radians; and the breadth of its line, rings.
    private const float CoverRing = 15.3f;
    private const float CoverBend = 2.4f;
    private const float CoverMiddle = 1.75f;
    private const float CoverReach = 0.95f;
    private const float Line = 0.34f;

    // Slits: rings of the first and the last, how many, and how broad each is in distances.
    private const float FirstSlit = 11.6f;
    private const float LastSlit = 15.2f;
    private const int Slits = 5;
    private const float Breadth = 0.3f;

    /// <summary>How dark gills are at a place, 0..1.</summary>
    /// <param name="mark">What is seen.</param>
    /// <param name="ring">Its ring of the body.</param>
    /// <param name="around">Radians around the body, 0 dorsal to π ventral.</param>
    public static float At(GillMark mark, float ring, float around)
    {
        switch (mark)
        {
            case GillMark.Cover:
                float off = (around - CoverMiddle) / CoverReach;
                float behind = ring - (CoverRing - (CoverBend * off * off));
                float edge = Scalar.Smooth(1f - Math.Abs(behind / Line));

                // The cover throws a shade on what is behind it.
                float shade = behind > 0f ? 0.5f * Scalar.Smooth(1f - (behind / (4f * Line))) : 0f;
                return Math.Max(edge, shade) * Scalar.Smooth((1f - Math.Abs(off)) * 4f);
            case GillMark.Slits:
                return Slit(ring) * Scalar.Smooth((0.42f - Math.Abs(around - 1.7f)) * 8f);
            case GillMark.DiscSlits:
                return Slit(ring) * Scalar.Smooth((0.14f - Math.Abs(Math.Min(around, (float)PortableMath.Pi - around) - 0.66f)) * 16f);
            default:
                return 0f;
        }
    }

    private static float Slit(float ring)
    {
        float step = (LastSlit - FirstSlit) / (Slits - 1);
        float number = (ring - FirstSlit) / step;
        float nearest = Scalar.Clamp((float)Math.Floor(number + 0.5), 0f, Slits - 1f);
        return Scalar.Smooth(1f - (Math.Abs(number - nearest) / Breadth));
    }
}
