using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Creatures;

/// <summary>Sets a nose of leather with its nostrils on the front of a muzzle, and nostrils on the sides of a bare snout and at the root of a beak.</summary>
internal static class NostrilSetter
{
    /// <summary>Squareness from which on a muzzle ends in a nose of leather.</summary>
    private const double LeatherFrom = 2.5;

    // Half width of a nostril, in those that its species tells of the muzzle's half width, or of that of its leather.
    private const double Breadth = 0.95;
    private const double OnLeather = 1.1;
    private const double InBeak = 0.75;

    // Half length of a nostril in half widths: on leather, on a bare snout, in a beak.
    private const float LongOnLeather = 1.45f;
    private const float LongOnSkin = 1.9f;
    private const float LongInBeak = 1.6f;

    /// <summary>Share of the coat's colour in that of a nose.</summary>
    private const float PaleLeather = 0.18f;

    // Direction of a nostril on a bare snout: it runs up and back.
    private const float Leaning = 0.9f;

    /// <summary>What the nose of leather of a muzzle that ends in one lies on; null for a muzzle that does not.</summary>
    public static NoseBed? BedOf(CreatureBlueprint blueprint, GrownSurface grown)
    {
        if (blueprint.Head.Beak != null || blueprint.Head.MuzzleSquareness <= LeatherFrom)
        {
            return null;
        }

        var pad = new NosePad(grown.Skin.Shape);
        return new NoseBed(pad, new MuzzleFront(grown.Surface, pad).Ahead);
    }

    /// <summary>Appends a nose of leather.</summary>
    public static void AppendLeather(PieceBuilder builder, in NoseBed bed, CoatPalette palette) => NosePadShape.Append(builder, bed, LeatherColour(palette));

    /// <summary>Appends both nostrils of a creature that has any. They move with the head.</summary>
    /// <param name="builder">Where they go.</param>
    /// <param name="blueprint">The creature.</param>
    /// <param name="grown">Its surface.</param>
    /// <param name="coat">Its colours.</param>
    /// <param name="beak">The beak that they are in; null for none.</param>
    /// <param name="leather">What the nose lies on that they are in; null for none.</param>
    public static void Append(PieceBuilder builder, CreatureBlueprint blueprint, GrownSurface grown, CoatPainter coat, BeakSetter? beak, NoseBed? leather)
    {
        CoatPalette palette = coat.Palette;
        BodyShape shape = grown.Skin.Shape;
        double size = blueprint.Head.NostrilSize;
        int first = builder.VertexCount;
        int index = builder.IndexCount;
        if (beak != null)
        {
            Vector3 colour = beak.IsNostrilSoft ? BeakSetter.SoftColour(palette, coat.BeakColour) : coat.BeakColour;
            NostrilShape.Append(builder, beak.Nostril, shape.Forward(StationRing.MuzzleMiddle), (float)(InBeak * shape.Width[StationRing.MuzzleMiddle] * size), LongInBeak, colour);
        }
        else if (leather is NoseBed bed)
        {
            NostrilShape.Append(builder, NosePadShape.Nostril(bed), bed.Pad.Up + (Vector3.UnitX * 0.5f), (float)(OnLeather * bed.Pad.HalfWidth * size), LongOnLeather, LeatherColour(palette));
        }
        else
        {
            bool painted = SpeciesCatalogue.Find(blueprint.Body.Blend.Face).Snout == SnoutKind.Beak;
            (float ring, float segment) = (painted ? 3.5f : 1.2f, 4.6f);
            SurfacePoint at = grown.Skin.At(ring, segment);
            Vector3 along = shape.Up(StationRing.Nostrils) - (shape.Forward(StationRing.Nostrils) * Leaning);
            var address = new VertexAddress { Region = SurfaceRegion.Body, Appendage = -1, Sign = 1, Ring = ring, Segment = segment };
            NostrilShape.Append(builder, at, along, (float)(Breadth * shape.Width[StationRing.Nostrils] * size), LongOnSkin, coat.At(address, at.Position, at.Normal));
        }

        builder.AppendMirrored(first, index);
    }

    /// <summary>The colour of a nose: a little lighter than that of the muzzle around it, or its nostrils would not be seen.</summary>
    private static Vector3 LeatherColour(CoatPalette palette) => Vec.Lerp(palette.Muzzle, palette.Base, PaleLeather);
}
