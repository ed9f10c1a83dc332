using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What the head wears over the coat of the trunk: marking, muzzle or beak, nose, lips and the ring around the eyes.</summary>
internal sealed class HeadCoat
{
    private const int LastRing = 28;

    // Metres at scale 1.
    private const float WidestRing = 0.04f;

    // Lightness of a coat, or of a hood, as OKLCH has it, up to which features of the face that are darker still are not seen at all, and that from which on they are.
    private const float Unseen = 0.36f;
    private const float Seen = 0.48f;

    // Lightness, as OKLCH has it, of what is pale in a dark face, and lightness and chroma of its beak, at least: of horn.
    private const double PaleLightness = 0.56;
    private const double PaleBeak = 0.52;
    private const double HornyChroma = 0.06;

    /// <summary>Share of the pale colour on the snout of a dark face.</summary>
    private const float PalePatch = 0.75f;

    /// <summary>Lips of a dark face, relative to what is pale in it.</summary>
    private const float PaleLip = 0.7f;

    // Lips and the line between them: breadth on either side in half widths of the muzzle, how much of that the edge takes, and shade.
    private const float LipBreadth = 0.17f;
    private const float LipBlur = 0.08f;
    private const float LipShade = 0.72f;
    private const float LineBreadth = 0.075f;
    private const float LineBlur = 0.06f;
    private const float LineShade = 0.3f;
    private const float PaleLineShade = 0.75f;

    /// <summary>How much darker than the coat gills are.</summary>
    private const float GillShade = 0.68f;

    /// <summary>How far back the leather of a nose may reach over its bridge, relative to the nostrils.</summary>
    private const double LeatherEnd = 0.9;

    // Lightness, as OKLCH has it, beyond which nothing is made lighter or darker to be told from a coat: it goes to its other side.
    private const double Darkest = 0.16;
    private const double Palest = 0.94;

    // Part of the faces with lips that have pores on their snouts, how much of them is seen, and their shade.
    private const float Pored = 0.7f;
    private const float PoreCover = 0.8f;
    private const float PoreShade = 0.4f;

    // Share of the muzzle's colour on the plates of an insect's face, and the shade of the seams around them.
    private const float PlateCover = 0.42f;
    private const float SeamShade = 0.4f;

    /// <summary>Share of the muzzle's colour on a bare snout.</summary>
    private const float BarePatch = 0.42f;

    // Share of the colour of noses on the tip of a bare snout, the part of it in a dark face, how far down its sides it goes, and over how much it runs out there, radians around the head: between its nostrils a bare snout is a blank plate.
    private const float TipCover = 0.5f;
    private const float TipInDark = 0.5f;
    private const float TipEnd = 1.3f;
    private const float TipEdge = 0.6f;

    // How much lighter and darker the planes of a face are, shares of light, and angle of the eyes from the middle below which there are none between them, radians.
    private const float PlaneLight = 0.85f;
    private const float PlaneShade = 0.62f;
    private const float NoPlanes = 0.5f;

    // Least distance of the ring around the eyes from the coat of the face, as OKLAB has it, and how much of its colour is laid on.
    private const double RingApart = 0.2;
    private const float RingCover = 0.8f;

    /// <summary>Lightness of a dark ring around the eyes against that of the limbs.</summary>
    private const double RingShade = 0.84;

    // Least distance, as OKLAB has it, of what a face wears from the coat of the face: of markings, muzzles and beaks.
    private const double MarkApart = 0.16;
    private const double MuzzleApart = 0.14;
    private const double BeakApart = 0.2;

    // The edge of a beak that is nothing but painted: its breadth in lengths of the front of the snout, and its shade.
    private const double EdgeBreadth = 0.16;
    private const float EdgeShade = 0.5f;

    // The skin below the horn of a beak: its shade, and how far ahead of the edge it begins, rings.
    private const float UnderHorn = 0.7f;
    private const float HornCover = 0.4f;

    private readonly CoatPalette palette;
    private readonly CoatSubject subject;
    private readonly Vector3 markColour;
    private readonly Vector3 ringColour;
    private readonly Vector3 muzzleColour;
    private readonly Vector3 paleColour;
    private readonly float dark;
    private readonly float pores;
    private readonly NosePad leather;
    private readonly HeadTone? tone;
    private readonly bool hasPlanes;

    public HeadCoat(CoatPalette palette, CoatSubject subject, CoatBlueprint coat)
    {
        this.palette = palette;
        this.subject = subject;
        leather = new NosePad(subject.Body);

        // Faces of insects have plates, and beaks are horn.
        bool isPlated = subject.Snout == SnoutKind.Bare && subject.Lips is null;
        hasPlanes = subject.EyeRadius > 0f && subject.EyeAround >= NoPlanes && subject.Snout != SnoutKind.Beak && subject.Beak == null && !isPlated;
        int patternSeed = coat.PatternSeed;
        pores = subject.Lips is not null && CoatChoice.Of(patternSeed, CoatChoice.Pores) < Pored ? PoreCover : 0f;
        float mark = CoatChoice.Of(patternSeed, CoatChoice.MarkColour);

        // The accent colour in a face suits vivid coats; on natural ones, and on a whole head, it clashes more often than not.
        float vivid = Scalar.Smooth(((float)coat.Base.Chroma - 0.085f) / 0.035f);
        float accent = vivid * (subject.Mark == HeadMark.Hood ? 0.12f : 0.42f);
        bool bright = subject.Mark != HeadMark.None && mark < accent;
        ColourBlueprint marked = mark < accent ? coat.Accent : mark < 0.8f ? coat.Pattern : subject.Mark == HeadMark.Hood ? coat.Limb : coat.Belly;
        tone = subject.Mark == HeadMark.Hood ? null : new HeadTone(coat);
        ColourBlueprint skin = tone != null ? coat.Base with { Lightness = tone.Lightness } : marked;
        markColour = OklchColour.ToLinearRgb(tone != null ? Apart(marked, skin, MarkApart) : Apart(marked, coat.Base, MarkApart));

        // Rings, lips and muzzles are darker than the coat; on a dark one nothing would be seen of them, so they are paler there, as those of bears and badgers are.
        double face = tone != null ? Math.Min(tone.Lightness, coat.Base.Lightness) : marked.Lightness;
        dark = 1f - Scalar.Smooth(((float)face - Unseen) / (Seen - Unseen));
        paleColour = AtLeast(coat.Belly, PaleLightness, chroma: 0);
        BeakColour = Vec.Lerp(OklchColour.ToLinearRgb(Apart(coat.Muzzle, skin, BeakApart)), AtLeast(coat.Muzzle, PaleBeak, HornyChroma), dark);
        ColourBlueprint around = bright || CoatChoice.Of(patternSeed, CoatChoice.EyeRing) > 0.4f * vivid ? coat.Limb with { Lightness = RingShade * coat.Limb.Lightness } : coat.Accent;
        Vector3 ring = OklchColour.ToLinearRgb(Apart(around, skin, RingApart));
        Vector3 muzzle = OklchColour.ToLinearRgb(Apart(CoatChoice.Of(patternSeed, CoatChoice.Muzzle) < 0.5f ? coat.Belly : coat.Limb, skin, MuzzleApart));
        ringColour = Vec.Lerp(ring, paleColour, dark);
        muzzleColour = Vec.Lerp(muzzle, paleColour, dark);
    }

    /// <summary>Linear RGB of a beak.</summary>
    public Vector3 BeakColour { get; }

    /// <summary>The colour of a place of the trunk with the head's own colours laid over <paramref name="colour"/>.</summary>
    public Vector3 Over(Vector3 colour, in SkinPlace place)
    {
        if (place.Ring > LastRing)
        {
            return colour;
        }

        colour = tone?.Over(colour, place.Ring) ?? colour;
        colour = Vec.Lerp(colour, markColour, 0.9f * HeadMarks.At(subject.Mark, place.Ring, place.Around));
        colour *= 1f - (GillShade * GillMarks.At(subject.Gills, place.Ring, place.Around));
        colour = EyeRing(Modelled(Snout(colour, place), place), place);
        colour = Vec.Lerp(colour, Vec.Lerp(colour * PoreShade, paleColour, dark), pores * SnoutPores.At(place.Ring, place.Around));
        return subject.Lips is MouthLine lips ? Lips(colour, lips.DistanceOf(place)) : colour;
    }

    /// <summary>A colour made as light and as strong as asked for where it is less, linear RGB.</summary>
    private static Vector3 AtLeast(ColourBlueprint colour, double lightness, double chroma) =>
        OklchColour.ToLinearRgb(Math.Max(colour.Lightness, lightness), Math.Max(colour.Chroma, chroma), colour.Hue);

    /// <summary>A colour made so much lighter or darker that it is told from another, where it is not.</summary>
    private static ColourBlueprint Apart(ColourBlueprint colour, ColourBlueprint from, double least)
    {
        double lighter = colour.Lightness - from.Lightness;
        double square = (colour.Chroma * colour.Chroma) + (from.Chroma * from.Chroma) - (2 * colour.Chroma * from.Chroma * PortableMath.Cos(colour.Hue - from.Hue));
        double lacks = Math.Sqrt(Math.Max(0, (least * least) - square));
        if (Math.Abs(lighter) >= lacks)
        {
            return colour;
        }

        bool up = lighter > 0 ? from.Lightness + lacks < Palest : from.Lightness - lacks < Darkest;
        return colour with { Lightness = from.Lightness + (up ? lacks : -lacks) };
    }

    /// <summary>Lips are a shade darker than what is around them, and darkest along the line in which they meet.</summary>
    private Vector3 Lips(Vector3 colour, float distance)
    {
        colour = Vec.Lerp(colour, Vec.Lerp(colour * LipShade, paleColour * PaleLip, dark), Scalar.Smooth((LipBreadth - distance) / LipBlur));
        return colour * Scalar.Lerp(1f, Scalar.Lerp(LineShade, PaleLineShade, dark), Scalar.Smooth((LineBreadth - distance) / LineBlur));
    }

    /// <summary>The colour with light and shade of the planes of a face.</summary>
    private Vector3 Modelled(Vector3 colour, in SkinPlace place)
    {
        if (!hasPlanes)
        {
            return colour;
        }

        float light = FaceShade.At(place.Ring, place.Around, subject.EyeRing, subject.EyeAround);
        return colour * (1f + (light * (light > 0f ? PlaneLight : PlaneShade)));
    }

    private Vector3 EyeRing(Vector3 colour, in SkinPlace place)
    {
        if (subject.EyeRadius <= 0f)
        {
            return colour;
        }

        // As wide as the eye's radius, but no halo around the huge eyes of insects.
        float width = Math.Min(subject.EyeRadius, WidestRing);
        float beyond = Vec.Distance(place.Position, subject.EyeCentre) - subject.EyeRadius;
        return Vec.Lerp(colour, ringColour, RingCover * Scalar.Smooth((width - beyond) / (0.8f * width)));
    }

    private Vector3 Snout(Vector3 colour, in SkinPlace place)
    {
        double[] arc = subject.Body.Arc;
        if (subject.Beak is BeakForm horn)
        {
            // What is below the horn; its edge lies on the coat.
            return Vec.Lerp(colour, BeakColour * UnderHorn, Scalar.Smooth(Math.Min(horn.Root.Lip, horn.Root.Chin) - HornCover - place.Ring));
        }

        if (subject.Snout == SnoutKind.Beak)
        {
            // Paler towards its root, where its edge meets the feathers, and dark at the tip.
            float beak = Scalar.Smooth((float)((arc[6] - place.Arc) / (0.25 * arc[2])));
            float shade = Scalar.Lerp(0.72f, 1.05f, Scalar.Smooth((float)(place.Arc / (0.6 * arc[6]))));
            float edge = Scalar.Smooth((float)(1 - (Math.Abs(arc[6] - (0.12 * arc[2]) - place.Arc) / (EdgeBreadth * arc[2]))));
            return Vec.Lerp(colour, BeakColour * shade, beak) * Scalar.Lerp(1f, EdgeShade, edge);
        }

        float patch = Scalar.Smooth((float)((arc[8] - place.Arc) / arc[4]));
        if (subject.Snout == SnoutKind.Bare && subject.Lips is null)
        {
            (float plate, float seam) = FacePlate.At(place.Ring, place.Around);
            return Vec.Lerp(colour, muzzleColour, PlateCover * plate) * Scalar.Lerp(1f, SeamShade, seam);
        }

        if (subject.Snout == SnoutKind.Bare)
        {
            float tip = Scalar.Smooth((float)((arc[StationRing.MuzzleFront + 1] - place.Arc) / arc[StationRing.MuzzleFront])) * Scalar.Smooth((TipEnd - place.Around) / TipEdge);
            return Vec.Lerp(Vec.Lerp(colour, muzzleColour, Scalar.Lerp(BarePatch, PalePatch, dark) * patch), palette.Muzzle, TipCover * Scalar.Lerp(1f, TipInDark, dark) * tip);
        }

        colour = Vec.Lerp(colour, muzzleColour, Scalar.Lerp(0.55f, PalePatch, dark) * patch);
        float nose = place.Region == SurfaceRegion.Nose || place.Arc < LeatherEnd * arc[1] ? leather.At(place.Position) : 0f;
        return Vec.Lerp(colour, palette.Muzzle, 0.92f * nose);
    }
}
