using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>The coat between the corners of a triangle: colours of the corners, and between them what is finer than the mesh, pattern and markings.</summary>
internal sealed class CoatBetween
{
    private const float LastRingOfHead = 16f;

    // Where the skin of a lip ends on its way into the mouth, in the first row of faces there, and the breadth of its edge: run out over all of it, the lips of an open mouth are a stain.
    private const float LipInside = 0.45f;
    private const float LipEdge = 0.2f;

    private readonly CoatPainter coat;

    public CoatBetween(CoatPainter coat) => this.coat = coat;

    /// <summary>Linear RGB, 0..1, at a place.</summary>
    public Vector3 At(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage, in Barycentric weights)
    {
        Vector4 position = weights.Mix(a.PositionAndRing, b.PositionAndRing, c.PositionAndRing);
        Vector4 plain = weights.Mix(a.PlainAndRun, b.PlainAndRun, c.PlainAndRun);
        Vector4 patterned = weights.Mix(a.PatternedAndGirth, b.PatternedAndGirth, c.PatternedAndGirth);
        float fraction = coat.PatternFraction(new PatternPlace(Xyz(position), plain.W, patterned.W));
        Vector3 colour = Vec.Lerp(Xyz(plain), Xyz(patterned), fraction);
        bool lips = (InMouth(a) || InMouth(b) || InMouth(c)) && !(InMouth(a) && InMouth(b) && InMouth(c));
        return lips || IsMarked(a.Region, position.W) ? Marked(a, b, c, appendage, weights, position, fraction, colour) : colour;
    }

    private static bool InMouth(in ChartCorner corner) => corner.Region == SurfaceRegion.Mouth;

    /// <summary>Whether a region has markings with edges finer than the mesh; everywhere else only the pattern is.</summary>
    private static bool IsMarked(SurfaceRegion region, float ring) =>
        region == SurfaceRegion.Body ? ring < LastRingOfHead : region is not (SurfaceRegion.Leg or SurfaceRegion.Toe) && !IsPlain(region);

    /// <summary>Whether a region is of one colour all over.</summary>
    private static bool IsPlain(SurfaceRegion region) => region is SurfaceRegion.Mouth or SurfaceRegion.Hoof or SurfaceRegion.EarInside;

    /// <summary>The markings over the coat at one place; where regions meet, each has the share of its corners.</summary>
    /// <remarks>The undercoat is that of the corners, and <paramref name="between"/> their finished colour.</remarks>
    private Vector3 Marked(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage, in Barycentric weights, in Vector4 position, float fraction, Vector3 between)
    {
        Vector4 chart = weights.Mix(a.ChartAndTurns, b.ChartAndTurns, c.ChartAndTurns);
        Vector4 plain = weights.Mix(a.PlainUndercoatAndAlong, b.PlainUndercoatAndAlong, c.PlainUndercoatAndAlong);
        Vector4 patterned = weights.Mix(a.PatternedUndercoatAndGrain, b.PatternedUndercoatAndGrain, c.PatternedUndercoatAndGrain);
        Vector3 undercoat = Vec.Lerp(Xyz(plain), Xyz(patterned), fraction);
        float grain = patterned.W;
        var address = new VertexAddress
        {
            Region = a.Region,
            Appendage = appendage,
            Sign = 1,
            Along = plain.W,
            Around = chart.W,
            Ring = position.W,
            Segment = chart.Z,
        };
        float mouth = weights.Mix(InMouth(a) ? 1f : 0f, InMouth(b) ? 1f : 0f, InMouth(c) ? 1f : 0f);
        if (mouth > 0f)
        {
            Vector3 lip = coat.MarkedAt(address with { Region = !InMouth(a) ? a.Region : !InMouth(b) ? b.Region : c.Region }, Xyz(position), undercoat, grain);
            Vector3 inside = Xyz(InMouth(a) ? a.PlainAndRun : InMouth(b) ? b.PlainAndRun : c.PlainAndRun);
            return Vec.Lerp(lip, inside, Scalar.Smooth((mouth - LipInside) / LipEdge));
        }

        Vector3 colour = coat.MarkedAt(address, Xyz(position), undercoat, grain);
        if (a.Region == b.Region && b.Region == c.Region)
        {
            return colour;
        }

        Vector3 second = b.Region == a.Region ? colour
            : IsPlain(b.Region) ? between
            : coat.MarkedAt(address with { Region = b.Region }, Xyz(position), undercoat, grain);
        Vector3 third = c.Region == a.Region ? colour
            : c.Region == b.Region ? second
            : IsPlain(c.Region) ? between
            : coat.MarkedAt(address with { Region = c.Region }, Xyz(position), undercoat, grain);
        return weights.Mix(colour, second, third);
    }

    private static Vector3 Xyz(in Vector4 v) => new(v.X, v.Y, v.Z);
}
