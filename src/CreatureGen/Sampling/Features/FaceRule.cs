using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>One thing before a face: horns, tusks and jaws of one species on the snout of another stand in front of what makes it a face.</summary>
internal static class FaceRule
{
    /// <summary>Last ring of a beak.</summary>
    private const double BeakEnd = 7;

    /// <summary>Takes off what crowds a face; what a species wears on its own head stays.</summary>
    public static void Clear(CreatureBuilder builder)
    {
        if (builder.Parents.Ornaments == builder.Parents.Head)
        {
            return;
        }

        bool beaked = builder.Parents.Head.Snout == SnoutKind.Beak;
        FeatureKind? kept = null;
        double longest = 0;
        foreach (FeatureBlueprint part in builder.Features)
        {
            if (IsBefore(part) && !IsBlade(part) && part.Length > longest)
            {
                (kept, longest) = (part.Kind, part.Length);
            }
        }

        builder.Features.RemoveAll(part => IsBefore(part) && ((beaked && part.Ring < BeakEnd) || IsBlade(part) || part.Kind != kept));
    }

    /// <summary>Whether something big is on the head already: a second thing would crowd it.</summary>
    public static bool IsDressed(CreatureBuilder builder) =>
        builder.Frills.Count > 0 || builder.Manes.Count > 0 || builder.Features.Exists(part => part.Kind != FeatureKind.Eye && part.Ring < StationRing.Nape + 1);

    /// <summary>Whether a part is a crest on the snout: on that of another species it stands between the eyes like a blade.</summary>
    private static bool IsBlade(FeatureBlueprint part) => part.Kind == FeatureKind.Plate && part.Ring < BeakEnd;

    /// <summary>Whether a part grows from the snout, or from the brow and forward.</summary>
    private static bool IsBefore(FeatureBlueprint part) =>
        part.Kind is not (FeatureKind.Eye or FeatureKind.Ocellus) && (part.Ring < BeakEnd || (part.Ring < StationRing.Brow && part.Forward > Math.Abs(part.Upward)));
}
