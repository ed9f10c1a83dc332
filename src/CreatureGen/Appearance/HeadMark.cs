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
}

/// <summary>Choice and outline of head markings.</summary>
internal static class HeadMarks
{
    /// <summary>The marking that goes with a coat's pattern seed: none for one creature in four.</summary>
    public static HeadMark FromSeed(int patternSeed)
    {
        float draw = CoatChoice.Of(patternSeed, CoatChoice.Mark);
        return draw < 0.25f ? HeadMark.None
            : draw < 0.39f ? HeadMark.Cheek
            : draw < 0.53f ? HeadMark.EyeLine
            : draw < 0.67f ? HeadMark.Bib
            : draw < 0.78f ? HeadMark.Crown
            : draw < 0.90f ? HeadMark.Blaze
            : HeadMark.Hood;
    }

    /// <summary>Share of the marking's colour, 0..1, at a ring of the body and an angle around it (0 dorsal, π ventral).</summary>
    public static float At(HeadMark mark, float ring, float around)
    {
        switch (mark)
        {
            case HeadMark.Hood:
                return Scalar.Smooth((19.5f - ring) / 1.2f);
            case HeadMark.Crown:
                return Scalar.Smooth((0.75f - around) / 0.2f) * Scalar.Smooth((18f - ring) / 2f) * Scalar.Smooth((ring - 5f) / 2f);
            case HeadMark.Cheek:
                float dr = (ring - 12.8f) / 3.0f;
                float da = (around - 1.75f) / 0.55f;
                return Scalar.Smooth((1f - (float)System.Math.Sqrt((dr * dr) + (da * da))) / 0.5f);
            case HeadMark.EyeLine:
                float off = System.Math.Abs(around - 1.27f - (0.02f * (ring - 9f)));
                return Scalar.Smooth((0.27f - off) / 0.20f) * Scalar.Smooth((17.5f - ring) / 2f) * Scalar.Smooth((ring - 2f) / 2f);
            case HeadMark.Bib:
                return Scalar.Smooth((around - 2.10f) / 0.25f) * Scalar.Smooth((ring - 15f) / 2f) * Scalar.Smooth((27f - ring) / 3f);
            case HeadMark.Blaze:
                return Scalar.Smooth((0.38f - around) / 0.22f) * Scalar.Smooth((12f - ring) / 2f);
            default:
                return 0f;
        }
    }
}
