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
                return Vec.Lerp(colour, finColour, 0.85f * rooted) * Scalar.Lerp(1f, rays * margin, Scalar.Smooth(place.Along * 4f));
            case SurfaceRegion.Wing:
                return place.Appendage >= 0 && place.Appendage < subject.WingStyles.Count && (subject.WingStyles[place.Appendage] == WingStyle.Folded || WingForm.Of(subject.WingStyles[place.Appendage]).Feathers > 0)
                    ? Feathers(colour, place)
                    : Membrane(colour, place);
            case SurfaceRegion.Ear:
                return Vec.Lerp(colour, palette.Limb * 0.8f, 0.7f * Scalar.Smooth((place.Along - 0.65f) / 0.3f));
            default:
                return colour;
        }
    }

    // The arm along the leading edge keeps the coat of the body.
    private Vector3 Membrane(Vector3 colour, in SkinPlace place)
    {
        float chord = place.Chord;
        float fraction = Scalar.Smooth((chord - 0.10f) / 0.15f) * Scalar.Smooth(place.Along * 4f);
        return Vec.Lerp(colour, membraneColour * (1.05f - (0.25f * chord)), fraction);
    }

    // Three rows from the leading edge: lesser coverts in the coat of the body, greater coverts, flight feathers.
    private Vector3 Feathers(Vector3 colour, in SkinPlace place)
    {
        float chord = place.Chord;
        float rooted = 0.9f * Scalar.Smooth(place.Along * 5f);
        colour = Vec.Lerp(colour, covertColour, rooted * Scalar.Smooth((chord - 0.30f) / 0.06f));
        return Vec.Lerp(colour, featherColour, rooted * Scalar.Smooth((chord - 0.62f) / 0.06f));
    }
}
