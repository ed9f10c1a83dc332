using System;

namespace CreatureGen.Anatomy.Legs;

/// <summary>All kinds of legs and arms: whoever needs something of one asks here.</summary>
internal static class LegKinds
{
    private static readonly LegKind[] all =
    {
        DigitigradeHindLeg.Kind,
        DigitigradeForeLeg.Kind,
        UnguligradeHindLeg.Kind,
        UnguligradeForeLeg.Kind,
        PlantigradeHindLeg.Kind,
        PlantigradeForeLeg.Kind,
        ColumnLeg.Kind,
        SprawlLeg.Kind,
        TheropodLeg.Kind,
        InsectLeg.Kind,
        HandedArm.Kind,
        BirdLeg.Kind,
        RaptorialLeg.Kind,
        JumperLeg.Kind,
        FrogHindLeg.Kind,
        FrogForeLeg.Kind,
    };

    /// <summary>In the order of their names in <see cref="LimbArchetype"/>.</summary>
    public static ReadOnlySpan<LegKind> All => all;

    /// <summary>What is known of an archetype.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such archetype.</exception>
    public static LegKind Of(LimbArchetype archetype) => archetype >= 0 && (int)archetype < all.Length
        ? all[(int)archetype]
        : throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "expected a known archetype");
}
