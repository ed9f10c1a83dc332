using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What thin appendages wear: rays on fins, membranes and feathers on wings, dark tips on ears.</summary>
internal sealed class BladeCoat
{
    // Rays of a fin, and how dark the skin between them is.
    private const int Rays = 11;
    private const float BetweenRays = 0.5f;

    // How much of the coat of the body the leading edge of a fin keeps, and the part of the chord over which that is lost: an edge as bright as its blade is a horn from ahead.
    private const float Leading = 0.8f;
    private const float LeadWidth = 0.35f;

    /// <summary>How far the skin over a finger keeps the coat of the body, in spans.</summary>
    private const float FingerWidth = 0.014f;

    // Where on the depth of a spread wing of feathers its greater coverts and its flight feathers begin, at the root and at the tip, how far the scallops of both rows reach, and how soft their edges are.
    private const float CovertsFrom = 0.3f;
    private const float CovertsAtTip = 0.2f;
    private const float FlightFrom = 0.62f;
    private const float FlightAtTip = 0.4f;
    private const float RowScallop = 0.025f;
    private const float RowEdge = 0.04f;

    // Of the folded wing: how many feathers lie over one another, and how far the scallops of a row reach along it.
    private const int FoldedFeathers = 5;
    private const float Scallop = 0.035f;

    private readonly CoatPalette palette;
    private readonly CoatSubject subject;
    private readonly Vector3 finColour;
    private readonly Vector3 membraneColour;
    private readonly Vector3 covertColour;
    private readonly Vector3 featherColour;

    public BladeCoat(CoatPalette palette, CoatSubject subject, int patternSeed)
    {
        this.palette = palette;
        this.subject = subject;
        float wing = CoatChoice.Of(patternSeed, CoatChoice.Wing);
        finColour = FinColour(palette, patternSeed);
        membraneColour = wing < 0.6f ? palette.Accent * 0.75f : palette.Pattern;
        covertColour = wing < 0.40f ? palette.Belly : wing < 0.65f ? palette.Accent : palette.Back;
        featherColour = palette.Limb * 0.8f;
    }

    /// <summary>The colour of fins.</summary>
    public static Vector3 FinColour(CoatPalette palette, int patternSeed) =>
        CoatChoice.Of(patternSeed, CoatChoice.Fin) < 0.65f ? palette.Accent : palette.Pattern;

    /// <summary>The colour of a place of a blade with its own colours laid over <paramref name="colour"/>, the coat of its root.</summary>
    public Vector3 Over(Vector3 colour, in SkinPlace place)
    {
        switch (place.Region)
        {
            case SurfaceRegion.Fin:
                float rays = 1f - (BetweenRays * 0.5f * (1f - (float)PortableMath.Cos(place.Chord * PortableMath.Tau * Rays)));
                float margin = 1f - (0.2f * Scalar.Smooth((place.Along - 0.8f) / 0.2f));
                float rooted = Scalar.Smooth(place.Along * 1.3f);
                float lead = 1f - (Leading * (1f - Scalar.Smooth(place.Chord / LeadWidth)));
                return Vec.Lerp(colour, finColour, 0.85f * rooted * lead) * Scalar.Lerp(1f, rays * margin, Scalar.Smooth(place.Along * 4f));
            case SurfaceRegion.Wing:
                WingStyle style = place.Appendage >= 0 && place.Appendage < subject.WingStyles.Count ? subject.WingStyles[place.Appendage] : WingStyle.Bat;
                return style == WingStyle.Folded ? Folded(colour, place)
                    : WingFingers.Of(style) is WingFingers hand ? Membrane(colour, place, hand)
                    : Feathers(colour, place, WingForm.Of(style).Feathers);
            case SurfaceRegion.Ear:
                return Vec.Lerp(colour, palette.Limb * 0.8f, 0.7f * Scalar.Smooth((place.Along - 0.65f) / 0.3f));
            default:
                return colour;
        }
    }

    // The arm along the leading edge and the fingers keep the coat of the body.
    private Vector3 Membrane(Vector3 colour, in SkinPlace place, WingFingers hand)
    {
        float chord = place.Chord;
        float fraction = Scalar.Smooth((chord - 0.10f) / 0.15f) * Scalar.Smooth(place.Along * 4f);
        if (fraction > 0f)
        {
            float off = hand.At(place.Along, chord) / FingerWidth;
            fraction *= 1f - (0.8f * Scalar.Smooth(1.6f - off));
        }

        return Vec.Lerp(colour, membraneColour * (1.05f - (0.25f * chord)), fraction);
    }

    // Three rows from the leading edge: lesser coverts in the coat of the body, greater coverts, flight feathers; each feather shades the next.
    private Vector3 Feathers(Vector3 colour, in SkinPlace place, int feathers)
    {
        float chord = place.Chord;
        float rooted = 0.9f * Scalar.Smooth(place.Along * 5f);
        float feather = place.Along * feathers;

        // Coverts end in a scallop each, those of the two rows between one another; towards the tip flight feathers are longer.
        float scallop = RowScallop * (float)PortableMath.Cos(PortableMath.Tau * feather);
        float coverts = Scalar.Lerp(CovertsFrom, CovertsAtTip, place.Along) - scallop;
        float flight = Scalar.Lerp(FlightFrom, FlightAtTip, place.Along) + scallop;
        colour = Vec.Lerp(colour, covertColour, rooted * Scalar.Smooth((chord - coverts) / RowEdge));
        colour = Vec.Lerp(colour, featherColour, rooted * Scalar.Smooth((chord - flight) / RowEdge));
        float row = Scalar.Smooth((chord - coverts) / (2f * RowEdge));
        float below = Math.Max(Scalar.Smooth(1f - (Math.Abs(chord - coverts - RowEdge) / (1.5f * RowEdge))), Scalar.Smooth(1f - (Math.Abs(chord - flight - RowEdge) / (1.5f * RowEdge))));
        return colour * (1f - (0.45f * rooted * Math.Max(below, row * Border(feather + (chord < flight ? 0.5f : 0f)))));
    }

    // Coverts over the wrist, greater coverts in the middle, and behind them primaries that run to the rear, one over the other.
    private Vector3 Folded(Vector3 colour, in SkinPlace place)
    {
        float chord = place.Chord;
        float feather = chord * FoldedFeathers;
        float back = place.Along + (0.22f * chord) + (Scallop * (float)PortableMath.Cos(PortableMath.Tau * feather));
        float rooted = 0.9f * Scalar.Smooth(place.Along * 5f);
        colour = Vec.Lerp(colour, covertColour, rooted * Scalar.Smooth((back - 0.36f) / 0.03f));
        colour = Vec.Lerp(colour, featherColour, rooted * Scalar.Smooth((back - 0.56f) / 0.03f));
        float rim = Math.Max(Scalar.Smooth(1f - (Math.Abs(back - 0.36f) / 0.03f)), Scalar.Smooth(1f - (Math.Abs(back - 0.56f) / 0.03f)));
        return colour * (1f - (0.45f * rooted * Math.Max(rim, Scalar.Smooth((back - 0.36f) / 0.1f) * Border(feather + 0.5f))));
    }

    /// <summary>How near it is to the border between two feathers, 0..1: sharp on one side, soft on the other.</summary>
    internal static float Border(float feathers)
    {
        float phase = feathers - (float)Math.Floor(feathers);
        return phase < 0.12f ? 1f - Scalar.Smooth(phase / 0.12f) : Scalar.Smooth((phase - 0.7f) / 0.3f);
    }
}
