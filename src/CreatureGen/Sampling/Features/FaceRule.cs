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

    // Longest part of another species in heights of the head, before the face and elsewhere along its middle: from the front a longer one is all that is seen of it.
    private const double LongestBefore = 0.7;
    private const double LongestAbove = 1.15;

    /// <summary>The same of a head's own horns before its face on another body.</summary>
    private const double LongestOwn = 0.8;

    // Where a crest of the snout goes on a mixed creature, and how: it lies back over the crown.
    private const double CrownRing = 12;
    private const double CrownOutward = 0.5;
    private const double CrownUpward = 0.25;

    /// <summary>Takes off what crowds a face and shortens what stays; what a species wears on its own head stays as it is; where that is on another body horns are shortened before and above it, and crests on the snout lie back over the crown.</summary>
    public static void Clear(CreatureBuilder builder)
    {
        bool own = builder.Parents.Ornaments == builder.Parents.Head;
        if (own && builder.Parents.Head == builder.Parents.First)
        {
            return;
        }

        double height = 2 * HeadSampler.HalfHeight(builder.Shape);
        Shorten(builder, part => part is { Segment: 0, Kind: FeatureKind.Horn or FeatureKind.Plate } && !IsBefore(part) && part.Ring <= StationRing.Nape, LongestAbove * height);
        if (own)
        {
            Shorten(builder, part => IsBefore(part) && !IsBlade(part) && part.Kind == FeatureKind.Horn, LongestOwn * height);
            Replace(builder, IsBlade, part => part with { Ring = CrownRing, Outward = CrownOutward, Upward = CrownUpward, Forward = -1 });
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
        Shorten(builder, IsBefore, LongestBefore * height);
    }

    private static void Shorten(CreatureBuilder builder, Predicate<FeatureBlueprint> which, double most) =>
        Replace(builder, part => which(part) && part.Length > most, part => part with { Length = most, Radius = part.Radius * Math.Sqrt(most / part.Length) });

    private static void Replace(CreatureBuilder builder, Predicate<FeatureBlueprint> which, Func<FeatureBlueprint, FeatureBlueprint> by)
    {
        for (int i = 0; i < builder.Features.Count; i++)
        {
            builder.Features[i] = which(builder.Features[i]) ? by(builder.Features[i]) : builder.Features[i];
        }
    }

    /// <summary>Whether something big is on the head already: a second thing would crowd it.</summary>
    public static bool IsDressed(CreatureBuilder builder) =>
        builder.Frills.Count > 0 || builder.Manes.Count > 0 || builder.Features.Exists(part => part.Kind != FeatureKind.Eye && part.Ring < StationRing.Nape + 1);

    /// <summary>Whether something stands along the middle of the face: a single eye would look out from behind it.</summary>
    public static bool IsHidden(CreatureBuilder builder) => builder.Features.Exists(part => part.Segment == 0 && IsBefore(part));

    /// <summary>Whether a part is a crest on the snout: on that of another species it stands between the eyes like a blade.</summary>
    private static bool IsBlade(FeatureBlueprint part) => part.Kind == FeatureKind.Plate && part.Ring < BeakEnd;

    /// <summary>Whether a part grows from the snout, or from the brow and forward.</summary>
    private static bool IsBefore(FeatureBlueprint part) =>
        part.Kind is not (FeatureKind.Eye or FeatureKind.Ocellus) && (part.Ring < BeakEnd || (part.Ring < StationRing.Brow && part.Forward > Math.Abs(part.Upward)));
}
