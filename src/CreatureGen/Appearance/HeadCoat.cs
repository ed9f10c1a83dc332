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

    /// <summary>How far back the leather of a nose may reach over its bridge, relative to the nostrils.</summary>
    private const double LeatherEnd = 0.9;

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
    private readonly NosePad leather;

    public HeadCoat(CoatPalette palette, CoatSubject subject, CoatBlueprint coat)
    {
        this.palette = palette;
        this.subject = subject;
        leather = new NosePad(subject.Body);
        int patternSeed = coat.PatternSeed;
        float mark = CoatChoice.Of(patternSeed, CoatChoice.MarkColour);

        // The accent colour in a face suits vivid coats; on natural ones, and on a whole head, it clashes more often than not.
        float vivid = Scalar.Smooth(((float)coat.Base.Chroma - 0.085f) / 0.035f);
        float accent = vivid * (subject.Mark == HeadMark.Hood ? 0.12f : 0.42f);
        bool bright = subject.Mark != HeadMark.None && mark < accent;
        ColourBlueprint marked = mark < accent ? coat.Accent : mark < 0.8f ? coat.Pattern : subject.Mark == HeadMark.Hood ? coat.Limb : coat.Belly;
        markColour = OklchColour.ToLinearRgb(marked);

        // Rings, lips and muzzles are darker than the coat; on a dark one nothing would be seen of them, so they are paler there, as those of bears and badgers are.
        double face = subject.Mark == HeadMark.Hood ? marked.Lightness : coat.Base.Lightness;
        dark = 1f - Scalar.Smooth(((float)face - Unseen) / (Seen - Unseen));
        paleColour = AtLeast(coat.Belly, PaleLightness, chroma: 0);
        BeakColour = Vec.Lerp(palette.Muzzle, AtLeast(coat.Muzzle, PaleBeak, HornyChroma), dark);
        Vector3 ring = bright || CoatChoice.Of(patternSeed, CoatChoice.EyeRing) > 0.4f * vivid ? palette.Limb * 0.6f : palette.Accent;
        Vector3 muzzle = CoatChoice.Of(patternSeed, CoatChoice.Muzzle) < 0.5f ? palette.Belly : palette.Limb;
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

        colour = Vec.Lerp(colour, markColour, 0.9f * HeadMarks.At(subject.Mark, place.Ring, place.Around));
        colour = EyeRing(colour, place);
        colour = Snout(colour, place);
        return subject.Lips is MouthLine lips ? Lips(colour, lips.DistanceOf(place)) : colour;
    }

    /// <summary>A colour made as light and as strong as asked for where it is less, linear RGB.</summary>
    private static Vector3 AtLeast(ColourBlueprint colour, double lightness, double chroma) =>
        OklchColour.ToLinearRgb(Math.Max(colour.Lightness, lightness), Math.Max(colour.Chroma, chroma), colour.Hue);

    /// <summary>Lips are a shade darker than what is around them, and darkest along the line in which they meet.</summary>
    private Vector3 Lips(Vector3 colour, float distance)
    {
        colour = Vec.Lerp(colour, Vec.Lerp(colour * LipShade, paleColour * PaleLip, dark), Scalar.Smooth((LipBreadth - distance) / LipBlur));
        return colour * Scalar.Lerp(1f, Scalar.Lerp(LineShade, PaleLineShade, dark), Scalar.Smooth((LineBreadth - distance) / LineBlur));
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
        return Vec.Lerp(colour, ringColour, 0.65f * Scalar.Smooth((width - beyond) / (0.8f * width)));
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
            return Vec.Lerp(colour, BeakColour * shade, beak);
        }

        float patch = Scalar.Smooth((float)((arc[8] - place.Arc) / arc[4]));
        if (subject.Snout == SnoutKind.Bare)
        {
            return Vec.Lerp(colour, muzzleColour, PalePatch * dark * patch);
        }

        colour = Vec.Lerp(colour, muzzleColour, Scalar.Lerp(0.55f, PalePatch, dark) * patch);
        float nose = place.Region == SurfaceRegion.Nose || place.Arc < LeatherEnd * arc[1] ? leather.At(place.Position) : 0f;
        return Vec.Lerp(colour, palette.Muzzle, 0.92f * nose);
    }
}
