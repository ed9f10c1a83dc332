using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>Paints the faces of a surface into some rows of the three pictures of an atlas, texel by texel. Each thread needs its own.</summary>
/// <remarks>Each texel is a place of the surface: what it shows depends on that place alone, so neither the order of the faces nor the seams between charts can be seen.</remarks>
internal sealed class TexturePainter
{
    /// <summary>Ring of the trunk at which a fin at the end of the tail begins, over how many it becomes bare, and by how much it does.</summary>
    private const float TailFinRing = 47.5f;
    private const float TailFinRings = 2.5f;
    private const float BareTailFin = 0.8f;

    private readonly CoatBetween coat;
    private readonly SkinRelief relief;
    private readonly AtlasPictures pictures;
    private readonly CoarseColours? coarse;
    private readonly RowBand rows;
    private readonly bool finned;

    /// <summary>A painter.</summary>
    /// <param name="coat">The coat.</param>
    /// <param name="relief">What covers the skin.</param>
    /// <param name="pictures">What to paint.</param>
    /// <param name="coarse">The coat at half the size, which all painters share; null to work it out at each texel.</param>
    /// <param name="rows">The rows to paint; even numbers where there are coarse colours.</param>
    public TexturePainter(CoatPainter coat, SkinRelief relief, AtlasPictures pictures, CoarseColours? coarse, RowBand rows)
    {
        this.coat = new CoatBetween(coat);
        finned = coat.HasTailFin;
        this.relief = relief;
        this.pictures = pictures;
        this.coarse = coarse;
        this.rows = rows;
    }

    /// <summary>Works out the coat of a face before it is painted, where the atlas is so large that it can be coarser. A face that was left out is only slower to paint.</summary>
    public void Sketch(in ChartFace face)
    {
        if (coarse != null && face.Touches(pictures.Size, rows))
        {
            Sketch(face.A, face.B, face.C, face.Appendage, coarse);
            Sketch(face.A, face.C, face.D, face.Appendage, coarse);
        }
    }

    /// <summary>Paints the texels whose middles lie in a face and that no other has painted.</summary>
    public void Paint(in ChartFace face)
    {
        if (face.Touches(pictures.Size, rows))
        {
            Paint(face.A, face.B, face.C, face.Appendage);
            Paint(face.A, face.C, face.D, face.Appendage);
        }
    }

    /// <summary>Whether there is a texel to paint in a face.</summary>
    /// <param name="a">First corner in the picture, 0..1.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="d">Fourth corner.</param>
    public bool HasGap(Vector2 a, Vector2 b, Vector2 c, Vector2 d)
    {
        var gap = new Gap(pictures);
        TriangleRaster.Fill(pictures.Size, rows, a, b, c, ref gap);
        TriangleRaster.Fill(pictures.Size, rows, a, c, d, ref gap);
        return gap.Found;
    }

    private void Sketch(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage, CoarseColours colours)
    {
        var pencil = new Pencil(coat, colours, a, b, c, appendage);
        TriangleRaster.Fill(colours.Size, new RowBand(rows.Top / 2, rows.End / 2), a.Picture, b.Picture, c.Picture, ref pencil);
    }

    private void Paint(in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage)
    {
        var brush = new Brush(this, a, b, c, appendage);
        TriangleRaster.Fill(pictures.Size, rows, a.Picture, b.Picture, c.Picture, ref brush);
    }

    /// <summary>How much of the skin's cover a region wears. Blades have no plates: those are stiff.</summary>
    private float Covered(SurfaceRegion region) => region switch
    {
        SurfaceRegion.Wing or SurfaceRegion.Ear when relief.IsPlated => 0f,
        SurfaceRegion.Body or SurfaceRegion.Leg => 1f,
        SurfaceRegion.Wing => 0.35f,
        SurfaceRegion.Fin => 0.1f,
        SurfaceRegion.Ear => 0.5f,
        SurfaceRegion.Toe => 0.5f,
        _ => 0.15f,
    };

    /// <summary>Nose and tip of the muzzle are bare: the rings of the chart run together there.</summary>
    private static float Muzzle(float ring, short appendage) => appendage >= 0 ? 1f : Scalar.Smooth((ring - 1.5f) / 7f);

    /// <summary>A fin at the end of the tail is as bare as all fins.</summary>
    private float TailFin(float ring, short appendage) => finned && appendage < 0 ? 1f - (BareTailFin * Scalar.Smooth((ring - TailFinRing) / TailFinRings)) : 1f;

    private float Roughness(SurfaceRegion region) => region switch
    {
        SurfaceRegion.Mouth => 0.3f,
        SurfaceRegion.Lip or SurfaceRegion.Nose => 0.4f,
        SurfaceRegion.Hoof => 0.45f,
        SurfaceRegion.EarInside => 0.65f,
        _ => relief.Roughness,
    };

    /// <summary>Finds whether a texel is not painted yet.</summary>
    private struct Gap : ITexelSink
    {
        private readonly AtlasPictures pictures;

        public Gap(AtlasPictures pictures)
        {
            this.pictures = pictures;
            Found = false;
        }

        public bool Found { get; private set; }

        public readonly bool Skips(int x, int y) => Found || pictures.IsPainted(x, y);

        public void Take(int x, int y, in Barycentric weights) => Found = true;
    }

    /// <summary>Puts the coat of a triangle into the coarse colours.</summary>
    private readonly struct Pencil : ITexelSink
    {
        private readonly CoatBetween coat;
        private readonly CoarseColours colours;
        private readonly ChartCorner a, b, c;
        private readonly short appendage;

        public Pencil(CoatBetween coat, CoarseColours colours, in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage)
        {
            this.coat = coat;
            this.colours = colours;
            this.a = a;
            this.b = b;
            this.c = c;
            this.appendage = appendage;
        }

        public bool Skips(int x, int y) => colours.Has(x, y);

        public void Take(int x, int y, in Barycentric weights) => colours.Set(x, y, coat.At(a, b, c, appendage, weights));
    }

    /// <summary>Paints a triangle into the pictures.</summary>
    private readonly struct Brush : ITexelSink
    {
        private readonly TexturePainter painter;
        private readonly ChartCorner a, b, c;
        private readonly short appendage;
        private readonly Vector3 covered;
        private readonly Vector3 roughness;

        public Brush(TexturePainter painter, in ChartCorner a, in ChartCorner b, in ChartCorner c, short appendage)
        {
            this.painter = painter;
            this.a = a;
            this.b = b;
            this.c = c;
            this.appendage = appendage;
            covered = new Vector3(painter.Covered(a.Region), painter.Covered(b.Region), painter.Covered(c.Region));
            roughness = new Vector3(painter.Roughness(a.Region), painter.Roughness(b.Region), painter.Roughness(c.Region));
        }

        public bool Skips(int x, int y) => painter.pictures.IsPainted(x, y);

        public void Take(int x, int y, in Barycentric weights)
        {
            if (painter.coarse == null || !painter.coarse.TryRead(x, y, out Vector3 colour))
            {
                colour = painter.coat.At(a, b, c, appendage, weights);
            }

            float ring = weights.Mix(a.PositionAndRing.W, b.PositionAndRing.W, c.PositionAndRing.W);
            float cover = weights.Mix(covered.X, covered.Y, covered.Z) * Muzzle(ring, appendage) * painter.TailFin(ring, appendage);
            Vector4 chart = weights.Mix(a.ChartAndTurns, b.ChartAndTurns, c.ChartAndTurns);
            SkinRelief relief = painter.relief;
            var place = new Vector2(chart.X, chart.Y);
            float height = appendage < 0 ? relief.OnBody(place, ring, chart.Z) : relief.OnLimb(place);
            colour *= 1f + (cover * relief.Shade * (height - 0.6f));
            float rough = weights.Mix(roughness.X, roughness.Y, roughness.Z) + (0.12f * cover * (0.5f - height));
            painter.pictures.Set(x, y, colour, cover * relief.Amplitude * height, rough, weights.Mix(a.Openness, b.Openness, c.Openness));
        }
    }
}
