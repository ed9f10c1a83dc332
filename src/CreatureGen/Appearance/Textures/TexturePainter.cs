using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>Paints the faces of a surface into the three pictures of an atlas, texel by texel.</summary>
/// <remarks>Each texel is a place of the surface: what it shows depends on that place alone, so neither the order of the faces nor the seams between charts can be seen.</remarks>
internal sealed class TexturePainter
{
    private const float LastRingOfHead = 16f;

    private readonly CoatPainter coat;
    private readonly SkinRelief relief;
    private readonly AtlasPictures pictures;

    public TexturePainter(CoatPainter coat, SkinRelief relief, AtlasPictures pictures)
    {
        this.coat = coat;
        this.relief = relief;
        this.pictures = pictures;
    }

    /// <summary>Paints the texels whose middles lie in a face.</summary>
    public void Paint(in ChartFace face)
    {
        Triangle(face.A, face.B, face.C, face.Appendage);
        Triangle(face.A, face.C, face.D, face.Appendage);
    }

    private void Triangle(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage)
    {
        int size = pictures.Size;
        Vector2 pa = a.Picture * size;
        Vector2 pb = b.Picture * size;
        Vector2 pc = c.Picture * size;
        float area = Cross(pb - pa, pc - pa);
        if (area == 0f)
        {
            return;
        }

        var covered = new Vector3(Covered(a.Region), Covered(b.Region), Covered(c.Region));
        var roughness = new Vector3(Roughness(a.Region), Roughness(b.Region), Roughness(c.Region));
        int top = Math.Max(0, (int)Math.Floor(Math.Min(pa.Y, Math.Min(pb.Y, pc.Y)) - 0.5));
        int bottom = Math.Min(size - 1, (int)Math.Ceiling(Math.Max(pa.Y, Math.Max(pb.Y, pc.Y)) - 0.5));
        int left = Math.Max(0, (int)Math.Floor(Math.Min(pa.X, Math.Min(pb.X, pc.X)) - 0.5));
        int right = Math.Min(size - 1, (int)Math.Ceiling(Math.Max(pa.X, Math.Max(pb.X, pc.X)) - 0.5));
        for (int y = top; y <= bottom; y++)
        {
            float first = left;
            float last = right;
            Narrow(pb, pc, area, y + 0.5f, ref first, ref last);
            Narrow(pc, pa, area, y + 0.5f, ref first, ref last);
            Narrow(pa, pb, area, y + 0.5f, ref first, ref last);
            ReadOnlySpan<bool> painted = pictures.PaintedRow(y);
            for (int x = (int)first; x <= last; x++)
            {
                if (painted[x])
                {
                    continue;
                }

                var p = new Vector2(x + 0.5f, y + 0.5f);
                float wa = Cross(pb - p, pc - p) / area;
                float wb = Cross(pc - p, pa - p) / area;
                float wc = 1f - wa - wb;

                // A hair's breadth outside counts, so that no texel between two faces is missed.
                if (Math.Min(wa, Math.Min(wb, wc)) < -1e-4f)
                {
                    continue;
                }

                var weights = new Barycentric(wa, wb, wc);
                Texel(a, b, c, appendage, weights, x, y, weights.Mix(covered.X, covered.Y, covered.Z), weights.Mix(roughness.X, roughness.Y, roughness.Z));
            }
        }
    }

    /// <summary>Narrows a row of texels to those on the inner side of an edge, and a texel more at either end.</summary>
    private static void Narrow(Vector2 from, Vector2 to, float area, float y, ref float first, ref float last)
    {
        float rise = to.Y - from.Y;
        if (rise == 0f)
        {
            return;
        }

        float crossing = from.X + ((to.X - from.X) * (y - from.Y) / rise);
        if (rise < 0f == area > 0f)
        {
            first = Math.Max(first, Math.Min(crossing - 1.5f, last + 1f));
        }
        else
        {
            last = Math.Min(last, crossing + 0.5f);
        }
    }

    private void Texel(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage, in Barycentric weights, int x, int y, float covered, float roughness)
    {
        Vector4 position = weights.Mix(a.PositionAndRing, b.PositionAndRing, c.PositionAndRing);
        Vector4 chart = weights.Mix(a.ChartAndTurns, b.ChartAndTurns, c.ChartAndTurns);
        Vector4 plain = weights.Mix(a.PlainAndRun, b.PlainAndRun, c.PlainAndRun);
        Vector4 patterned = weights.Mix(a.PatternedAndGirth, b.PatternedAndGirth, c.PatternedAndGirth);
        float share = coat.PatternShare(new PatternPlace(Xyz(position), plain.W, patterned.W));
        Vector3 colour = Vec.Lerp(Xyz(plain), Xyz(patterned), share);
        if (IsMarked(a.Region, position.W))
        {
            colour = Marked(a, b, c, appendage, weights, position, chart, share, colour);
        }

        covered *= Muzzle(position.W, appendage);
        float height = relief.At(new Vector2(chart.X, chart.Y));
        colour *= 1f + (covered * relief.Shade * (height - 0.6f));
        pictures.Set(x, y, colour, covered * relief.Amplitude * height, roughness + (0.12f * covered * (0.5f - height)));
    }

    /// <summary>Whether a region has markings with edges finer than the mesh; everywhere else only the pattern is.</summary>
    private static bool IsMarked(SurfaceRegion region, float ring) =>
        region == SurfaceRegion.Body ? ring < LastRingOfHead : region is not (SurfaceRegion.Leg or SurfaceRegion.Toe) && !IsPlain(region);

    /// <summary>Whether a region is of one colour all over.</summary>
    private static bool IsPlain(SurfaceRegion region) => region is SurfaceRegion.Mouth or SurfaceRegion.Hoof or SurfaceRegion.EarInside;

    /// <summary>The markings over the coat at one place; where regions meet, each has the share of its corners.</summary>
    /// <remarks>The undercoat is that of the corners, and <paramref name="between"/> their finished colour.</remarks>
    private Vector3 Marked(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage, in Barycentric weights, in Vector4 position, in Vector4 chart, float share, Vector3 between)
    {
        Vector4 plain = weights.Mix(a.PlainUndercoatAndAlong, b.PlainUndercoatAndAlong, c.PlainUndercoatAndAlong);
        Vector4 patterned = weights.Mix(a.PatternedUndercoatAndGrain, b.PatternedUndercoatAndGrain, c.PatternedUndercoatAndGrain);
        Vector3 undercoat = Vec.Lerp(Xyz(plain), Xyz(patterned), share);
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
        float grain = patterned.W;
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

    /// <summary>How much of the skin's cover a region wears.</summary>
    private static float Covered(SurfaceRegion region) => region switch
    {
        SurfaceRegion.Body or SurfaceRegion.Leg => 1f,
        SurfaceRegion.Wing or SurfaceRegion.Fin => 0.35f,
        SurfaceRegion.Ear => 0.5f,
        SurfaceRegion.Toe => 0.5f,
        _ => 0.15f,
    };

    /// <summary>Nose and tip of the muzzle are bare: the rings of the chart run together there.</summary>
    private static float Muzzle(float ring, short appendage) => appendage >= 0 ? 1f : Scalar.Smooth((ring - 1.5f) / 7f);

    private float Roughness(SurfaceRegion region) => region switch
    {
        SurfaceRegion.Mouth => 0.3f,
        SurfaceRegion.Lip or SurfaceRegion.Nose => 0.4f,
        SurfaceRegion.Hoof => 0.45f,
        SurfaceRegion.EarInside => 0.65f,
        _ => relief.Roughness,
    };

    private static Vector3 Xyz(in Vector4 v) => new(v.X, v.Y, v.Z);

    private static float Cross(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
