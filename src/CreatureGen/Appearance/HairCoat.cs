using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The skin under a mane: as dark as its roots, so that no bare skin shows between locks, with soft edges.</summary>
internal sealed class HairCoat
{
    // How far the shade reaches beyond the roots, and over what it fades: rings and segments.
    private const float Ahead = 0.6f;
    private const float Behind = 1.4f;
    private const float Beside = 1.3f;
    private const float Fade = 1.2f;
    private const float Shade = 0.6f;

    private readonly IReadOnlyList<ManeBlueprint> manes;
    private readonly Vector3 colour;

    public HairCoat(CoatPalette palette, CoatSubject subject)
    {
        manes = subject.Manes;
        colour = ColourOf(palette, manes) * Shade;
    }

    /// <summary>The colour of all hair of a creature: that of its ornaments; hair of the tail alone is the coat's own, dark or pale as the limbs are.</summary>
    public static Vector3 ColourOf(CoatPalette palette, IReadOnlyList<ManeBlueprint> manes) => manes.Any(mane => mane.IsOfBody) ? palette.Accent : palette.Limb;

    /// <summary>The colour of a place of the trunk with the shade of hair laid over <paramref name="under"/>.</summary>
    public Vector3 Over(Vector3 under, in SkinPlace place)
    {
        float fraction = 0f;
        foreach (ManeBlueprint mane in manes)
        {
            float along = Window(place.Ring, (float)mane.Ring - Ahead, (float)mane.LastRing + Behind);
            if (along > 0f)
            {
                float segment = place.Around * (float)(BodyGrid.Segments / PortableMath.Tau);
                fraction = Math.Max(fraction, along * Window(segment, (float)mane.Segment - Beside, (float)mane.LastSegment + Beside));
            }
        }

        return fraction > 0f ? Vec.Lerp(under, colour, 0.92f * fraction) : under;
    }

    private static float Window(float x, float first, float last) => Scalar.Smooth((x - first + Fade) / Fade) * Scalar.Smooth((last + Fade - x) / Fade);
}
