using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Appearance;
using CreatureGen.Appearance.Textures;
using CreatureGen.Concurrency;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;

namespace CreatureGen.Creatures;

/// <summary>
/// The texture atlas of a creature: base colour, normals, and roughness with ambient occlusion, on the texture coordinates of its mesh. Square pictures, three bytes per texel, rows from the top.
/// </summary>
/// <remarks>
/// Every texel is a place of the surface at rest: coat, scales, fur or feathers are evaluated there, so seams between charts do not show and left and right are alike.
/// From 1024 texels a side on, the coat is evaluated at every second texel of every second row, and smoothly between; its finest edges are several texels wide there.
/// Pieces set into the skin (eyes, claws, horns, teeth) keep their vertex colours and lie on white texels; the skin's vertex colours are not to be multiplied with the base colour.
/// </remarks>
public sealed class CreatureTextures
{
    /// <summary>Least texels along a side.</summary>
    public const int SmallestSize = 256;

    /// <summary>Most texels along a side.</summary>
    public const int LargestSize = 4096;

    private readonly byte[] baseColour;
    private readonly byte[] normal;
    private readonly byte[] roughness;

    private CreatureTextures(AtlasPictures pictures)
    {
        Size = pictures.Size;
        baseColour = pictures.BaseColour;
        normal = pictures.Normal;
        roughness = pictures.Roughness;
    }

    /// <summary>Texels along a side.</summary>
    public int Size { get; }

    /// <summary>Base colour, sRGB.</summary>
    public ReadOnlySpan<byte> BaseColour => baseColour;

    /// <summary>Normals in tangent space as glTF has them: red along u, green against v, blue outwards; 128 is nought.</summary>
    public ReadOnlySpan<byte> Normal => normal;

    /// <summary>Ambient occlusion in the red channel (<see cref="AmbientOcclusionOf"/>; 255 in the open), roughness in the green one, metalness (none) in the blue one.</summary>
    public ReadOnlySpan<byte> Roughness => roughness;

    /// <summary>Paints the atlas of a creature. The same creature and size give the same bytes.</summary>
    /// <param name="creature">The creature; its blueprint says all that is needed.</param>
    /// <param name="size">Texels along a side, a power of two 256..4096.</param>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The size is not a power of two within its range.</exception>
    public static CreatureTextures Bake(Creature creature, int size)
    {
        if (creature is null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        if (size < SmallestSize || size > LargestSize || (size & (size - 1)) != 0)
        {
            throw new ArgumentOutOfRangeException(nameof(size), size, "expected a power of two 256..4096");
        }

        GrownSurface grown = GrownSurface.Grow(creature.Blueprint);
        Surface surface = grown.Surface;
        var normals = new Vector3[surface.Positions.Length];
        SurfaceNormals.Smooth(surface.Positions, surface.Triangles, surface.Mirror, normals);
        EyeFrame eye = EyeSetter.EyeOf(creature.Blueprint, grown);
        using var pictures = new AtlasPictures(size);
        PaintSwatches(pictures);
        ChartPacking packing = ChartPacking.Pack(surface);
        float[] openness = AmbientOcclusion.Of(creature).OfAll(surface.Positions, normals, (float)creature.Blueprint.Scale);
        Paint(surface, packing, new VertexCoat(Coat(), surface, normals, openness), size, PainterOf);
        pictures.Bleed(Math.Max(2, size / 256));
        Finish(pictures, 1f / (packing.Density * size));
        return new CreatureTextures(pictures);

        CoatPainter Coat() => new(creature.Blueprint.Coat, CoatSubjects.Of(creature.Blueprint, grown, eye));
        TexturePainter PainterOf(RowBand rows, CoarseColours? coarse) => new(Coat(), CoatSubjects.ReliefOf(creature.Blueprint), pictures, coarse, rows);
    }

    /// <summary>
    /// The share of the light from all around, 0.2..1, that reaches each vertex of a creature's mesh at rest past its own limbs, head and tail: for who draws with vertex colours, which are to be multiplied with it; the atlas has it.
    /// </summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static float[] AmbientOcclusionOf(Creature creature)
    {
        CreatureMesh mesh = creature?.Mesh ?? throw new ArgumentNullException(nameof(creature));
        return AmbientOcclusion.Of(creature).OfAll(mesh.Positions, mesh.Normals, 1f);
    }

    /// <summary>
    /// Whether a vertex with these texture coordinates lies on white texels and keeps its own colour, as eyes, claws and teeth do; all others have their colour in the base colour picture.
    /// </summary>
    public static bool KeepsItsColour(Vector2 texcoord) => ChartPacking.IsSwatch(texcoord);

    /// <summary>Texture coordinates of a place that leaves a surface its colour.</summary>
    internal static Vector2 PlainTexcoord => ChartPacking.Swatch(0);

    private static void PaintSwatches(AtlasPictures pictures)
    {
        int side = ChartPacking.SwatchSide(pictures.Size);
        foreach (SurfaceFinish finish in new[] { SurfaceFinish.Skin, SurfaceFinish.Horn, SurfaceFinish.Tooth, SurfaceFinish.Eye, SurfaceFinish.Wing, SurfaceFinish.Hair })
        {
            pictures.SetPlain((int)finish * side, 0, side, RoughnessOf(finish));
        }
    }

    private static float RoughnessOf(SurfaceFinish finish) => finish switch
    {
        SurfaceFinish.Horn => 0.4f,
        SurfaceFinish.Tooth => 0.25f,
        SurfaceFinish.Eye => 0.07f,
        SurfaceFinish.Wing => 0.3f,
        SurfaceFinish.Hair => 0.8f,
        _ => 0.65f,
    };

    /// <summary>Paints band by band. The right side shares the texels of the left; few faces of it, if any, find one that is not painted yet.</summary>
    private static void Paint(Surface surface, ChartPacking packing, VertexCoat coat, int size, Func<RowBand, CoarseColours?, TexturePainter> painterOf)
    {
        using var left = new PooledList<ChartFace>(surface.Faces.Length / 2);
        var right = new List<int>(surface.Faces.Length / 2);
        for (int f = 0; f < surface.Faces.Length; f++)
        {
            if (IsRight(surface, f))
            {
                right.Add(f);
            }
            else
            {
                left.Add(ChartFace.Of(surface, packing, f, coat));
            }
        }

        using CoarseColours? coarse = size >= CoarseColours.MinAtlas ? new CoarseColours(size) : null;
        if (coarse != null)
        {
            ForEachBand(size, rows => Each(left, painterOf(rows, coarse).Sketch));
        }

        ForEachBand(size, rows => Each(left, painterOf(rows, coarse).Paint));
        TexturePainter last = painterOf(RowBand.All(size), coarse);

        // What has no gap before the first of them is painted has none later: they can be looked at side by side.
        bool[] gaps = new bool[right.Count];
        IndependentParts.Run(RowBand.Count, part =>
        {
            for (int i = gaps.Length * part / RowBand.Count; i < gaps.Length * (part + 1) / RowBand.Count; i++)
            {
                gaps[i] = HasGap(surface, packing, right[i], last);
            }
        });
        for (int i = 0; i < gaps.Length; i++)
        {
            if (gaps[i])
            {
                last.Paint(ChartFace.Of(surface, packing, right[i], coat));
            }
        }
    }

    /// <summary>Colours the ground of two pictures and makes the third of the heights, side by side.</summary>
    private static void Finish(AtlasPictures pictures, float texel)
    {
        byte[][] grounded = { pictures.BaseColour, pictures.Roughness };
        IndependentParts.Run(grounded.Length + RowBand.Count, part =>
        {
            if (part < grounded.Length)
            {
                pictures.FillGround(grounded[part]);
            }
            else
            {
                pictures.Emboss(texel, RowBand.Of(pictures.Size, part - grounded.Length));
            }
        });
    }

    private delegate void FaceAction(in ChartFace face);

    /// <summary>Does something with each face where it lies: half a kilobyte each is not copied for every band.</summary>
    private static void Each(PooledList<ChartFace> faces, FaceAction action)
    {
        foreach (ref readonly ChartFace face in faces.Items)
        {
            action(face);
        }
    }

    /// <summary>Does something to all bands of rows of a picture, side by side.</summary>
    private static void ForEachBand(int size, Action<RowBand> action) => IndependentParts.Run(RowBand.Count, band => action(RowBand.Of(size, band)));

    private static bool HasGap(Surface surface, ChartPacking packing, int f, TexturePainter painter)
    {
        int chart = surface.Faces[f].Chart;
        FaceTexcoords t = surface.Texcoords[f];
        return painter.HasGap(packing.Map(chart, t.A), packing.Map(chart, t.B), packing.Map(chart, t.C), packing.Map(chart, t.D));
    }

    private static bool IsRight(Surface surface, int f)
    {
        Face face = surface.Faces[f];
        return surface.Addresses[face.A].Sign < 0 || surface.Addresses[face.B].Sign < 0 || surface.Addresses[face.C].Sign < 0 || surface.Addresses[face.D].Sign < 0;
    }
}
