using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What the head wears over the coat of the trunk: marking, muzzle or beak, nose, lips and the ring around the eyes.</summary>
internal sealed class HeadCoat
{
    private const int LastRing = 28;

    // Metres at scale 1.
    private const float WidestRing = 0.04f;

    private readonly CoatPalette palette;
    private readonly CoatSubject subject;
    private readonly Vector3 markColour;
    private readonly Vector3 ringColour;
    private readonly Vector3 muzzleColour;

    public HeadCoat(CoatPalette palette, CoatSubject subject, CoatBlueprint coat)
    {
        this.palette = palette;
        this.subject = subject;
        int patternSeed = coat.PatternSeed;
        float mark = CoatChoice.Of(patternSeed, CoatChoice.MarkColour);

        // The accent colour in a face suits vivid coats; on natural ones, and on a whole head, it clashes more often than not.
        float vivid = Scalar.Smooth(((float)coat.Base.Chroma - 0.085f) / 0.035f);
        float accent = vivid * (subject.Mark == HeadMark.Hood ? 0.12f : 0.42f);
        bool bright = subject.Mark != HeadMark.None && mark < accent;
        markColour = mark < accent ? palette.Accent : mark < 0.8f ? palette.Pattern : subject.Mark == HeadMark.Hood ? palette.Limb : palette.Belly;
        ringColour = bright || CoatChoice.Of(patternSeed, CoatChoice.EyeRing) > 0.4f * vivid ? palette.Limb * 0.6f : palette.Accent;
        muzzleColour = CoatChoice.Of(patternSeed, CoatChoice.Muzzle) < 0.5f ? palette.Belly : palette.Limb;
    }

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
        return place.Region == SurfaceRegion.Lip ? colour * (subject.Snout == SnoutKind.Beak ? 0.8f : 0.55f) : colour;
    }

    private Vector3 EyeRing(Vector3 colour, in SkinPlace place)
    {
        if (subject.EyeRadius <= 0f)
        {
            return colour;
        }

        // As wide as the eye's radius, but no halo around the huge eyes of insects.
        float width = System.Math.Min(subject.EyeRadius, WidestRing);
        float beyond = Vec.Distance(place.Position, subject.EyeCentre) - subject.EyeRadius;
        return Vec.Lerp(colour, ringColour, 0.65f * Scalar.Smooth((width - beyond) / (0.8f * width)));
    }

    private Vector3 Snout(Vector3 colour, in SkinPlace place)
    {
        double[] arc = subject.Body.Arc;
        if (subject.Snout == SnoutKind.Beak)
        {
            // Paler towards its root, where its edge meets the feathers, and dark at the tip.
            float beak = Scalar.Smooth((float)((arc[6] - place.Arc) / (0.25 * arc[2])));
            float shade = Scalar.Lerp(0.72f, 1.05f, Scalar.Smooth((float)(place.Arc / (0.6 * arc[6]))));
            return Vec.Lerp(colour, palette.Muzzle * shade, beak);
        }

        if (subject.Snout == SnoutKind.Bare)
        {
            return colour;
        }

        float dorsal = 1f - (2f * place.Ventral);
        colour = Vec.Lerp(colour, muzzleColour, 0.55f * Scalar.Smooth((float)((arc[8] - place.Arc) / arc[4])));
        float nose = place.Region == SurfaceRegion.Nose ? Scalar.Smooth((dorsal + 0.2f) / 0.3f)
            : place.Arc < 0.9 * arc[1] ? Scalar.Smooth((dorsal + 0.15f) / 0.12f)
            : 0f;
        return Vec.Lerp(colour, palette.Muzzle, 0.92f * nose);
    }
}
