using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>A marking that makes a face recognisable from afar.</summary>
internal enum HeadMark
{
    /// <summary>None.</summary>
    None,

    /// <summary>The whole head.</summary>
    Hood,

    /// <summary>The top of the head.</summary>
    Crown,

    /// <summary>A round patch behind the eye.</summary>
    Cheek,

    /// <summary>A line through the eye.</summary>
    EyeLine,

    /// <summary>Throat and chest.</summary>
    Bib,

    /// <summary>A stripe from nose to brow.</summary>
    Blaze,

    /// <summary>A band across the face through both eyes.</summary>
    Mask,
}

/// <summary>Choice and outline of head markings.</summary>
internal static class HeadMarks
{
    // Where a hood runs out, rings: over the length of a neck, in scallops around it.
    private const float HoodEnd = 21.5f;
    private const float HoodFade = 6.5f;
    private const float Scallop = 0.7f;
    private const float Scallops = 6f;

    /// <summary>How much narrower a bib is at the throat than at the chest, radians on either side: cut off square it is a hole from the side.</summary>
    private const float BibPoint = 0.65f;

    /// <summary>The marking that goes with a coat's pattern seed: none for one creature in six.</summary>
    public static HeadMark FromSeed(int patternSeed)
    {
        float draw = CoatChoice.Of(patternSeed, CoatChoice.Mark);
        return draw < 0.17f ? HeadMark.None
            : draw < 0.29f ? HeadMark.Cheek
            : draw < 0.43f ? HeadMark.EyeLine
            : draw < 0.56f ? HeadMark.Bib
            : draw < 0.68f ? HeadMark.Crown
            : draw < 0.79f ? HeadMark.Blaze
            : draw < 0.91f ? HeadMark.Mask
            : HeadMark.Hood;
    }

    /// <summary>Share of the marking's colour, 0..1, at a ring of the body and an angle around it (0 dorsal, π ventral).</summary>
    public static float At(HeadMark mark, float ring, float around)
    {
        switch (mark)
        {
            case HeadMark.Hood:
                return Scalar.Smooth((HoodEnd - ring - (Scallop * (float)PortableMath.Cos(Scallops * around))) / HoodFade);
            case HeadMark.Crown:
                return Scalar.Smooth((0.75f - around) / 0.2f) * Scalar.Smooth((20f - ring) / 4f) * Scalar.Smooth((ring - 5f) / 2f);
            case HeadMark.Cheek:
                float dr = (ring - 12.8f) / 3.0f;
                float da = (around - 1.75f) / 0.55f;
                return Scalar.Smooth((1f - (float)System.Math.Sqrt((dr * dr) + (da * da))) / 0.5f);
            case HeadMark.EyeLine:
                float off = System.Math.Abs(around - 1.27f - (0.02f * (ring - 9f)));
                return Scalar.Smooth((0.27f - off) / 0.20f) * Scalar.Smooth((17.5f - ring) / 2f) * Scalar.Smooth((ring - 2f) / 2f);
            case HeadMark.Bib:
                float narrowing = BibPoint * (1f - Scalar.Smooth((ring - 13f) / 7f));
                return Scalar.Smooth((around - 2.05f - narrowing) / 0.4f) * Scalar.Smooth((ring - 12f) / 4f) * Scalar.Smooth((27.5f - ring) / 5.5f);
            case HeadMark.Blaze:
                return Scalar.Smooth((0.38f - around) / 0.22f) * Scalar.Smooth((12f - ring) / 2f);
            case HeadMark.Mask:
                return Scalar.Smooth((2.6f - System.Math.Abs(ring - 10.4f + (1.2f * (around - 1.2f)))) / 1.1f) * Scalar.Smooth((1.95f - around) / 0.4f);
            default:
                return 0f;
        }
    }
}
