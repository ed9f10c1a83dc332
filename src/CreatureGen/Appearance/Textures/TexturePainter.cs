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
        Triangle(face, face.A, face.B, face.C, face.PictureA, face.PictureB, face.PictureC, face.RegionA, face.RegionB, face.RegionC);
        Triangle(face, face.A, face.C, face.D, face.PictureA, face.PictureC, face.PictureD, face.RegionA, face.RegionC, face.RegionD);
    }

    private void Triangle(in ChartFace face, in TexelPlace a, in TexelPlace b, in TexelPlace c, Vector2 pa, Vector2 pb, Vector2 pc, SurfaceRegion ra, SurfaceRegion rb, SurfaceRegion rc)
    {
        int size = pictures.Size;
        pa *= size;
        pb *= size;
        pc *= size;
        float area = Cross(pb - pa, pc - pa);
        if (area == 0f)
        {
            return;
        }

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
            for (int x = (int)first; x <= last; x++)
            {
                var p = new Vector2(x + 0.5f, y + 0.5f);
                float wa = Cross(pb - p, pc - p) / area;
                float wb = Cross(pc - p, pa - p) / area;
                float wc = 1f - wa - wb;

                // A hair's breadth outside counts, so that no texel between two faces is missed.
                if (Math.Min(wa, Math.Min(wb, wc)) < -1e-4f || pictures.IsPainted(x, y))
                {
                    continue;
                }

                TexelPlace place = TexelPlace.Between(a, b, c, wa, wb, wc);
                Texel(face, place, x, y, wa, wb, wc, ra, rb, rc);
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

    private void Texel(in ChartFace face, in TexelPlace place, int x, int y, float wa, float wb, float wc, SurfaceRegion ra, SurfaceRegion rb, SurfaceRegion rc)
    {
        float covered = (Covered(ra) * wa) + (Covered(rb) * wb) + (Covered(rc) * wc);
        float roughness = (Roughness(ra) * wa) + (Roughness(rb) * wb) + (Roughness(rc) * wc);
        Vector3 colour = IsDetailed(ra, place.Ring)
            ? Detailed(face, place, wa, wb, wc, ra, rb, rc)
            : Vec.Lerp(place.Plain, place.Patterned, coat.PatternShare(new PatternPlace(place.Position, place.Run, place.Girth)));
        covered *= Muzzle(place.Ring, face.Appendage);
        float height = relief.At(place.Chart);
        colour *= 1f + (covered * relief.Shade * (height - 0.6f));
        pictures.Set(x, y, colour, covered * relief.Amplitude * height, roughness + (0.12f * covered * (0.5f - height)));
    }

    /// <summary>Whether a region has markings with edges finer than the mesh; everywhere else only the pattern is.</summary>
    private static bool IsDetailed(SurfaceRegion region, float ring) =>
        region is not (SurfaceRegion.Body or SurfaceRegion.Leg or SurfaceRegion.Toe) || (region == SurfaceRegion.Body && ring < LastRingOfHead);

    /// <summary>The whole coat at one place; where regions meet, each has the share of its corners.</summary>
    private Vector3 Detailed(in ChartFace face, in TexelPlace place, float wa, float wb, float wc, SurfaceRegion ra, SurfaceRegion rb, SurfaceRegion rc)
    {
        Vector3 normal = place.UnitNormal;
        Vector3 colour = coat.At(place.Address(ra, face.Appendage), place.Position, normal);
        if (ra == rb && rb == rc)
        {
            return colour;
        }

        Vector3 second = rb == ra ? colour : coat.At(place.Address(rb, face.Appendage), place.Position, normal);
        Vector3 third = rc == ra ? colour : rc == rb ? second : coat.At(place.Address(rc, face.Appendage), place.Position, normal);
        return (colour * wa) + (second * wb) + (third * wc);
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

    private static float Cross(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
