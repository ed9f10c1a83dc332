namespace CreatureGen.Anatomy.Legs;

/// <summary>
/// All that is known of a kind of leg or arm: how it looks, how it fits the body, how far its joints turn, how it steps and how it is held in flight. Each kind is one file of this folder; one of
/// which anything is missing does not compile.
/// </summary>
internal sealed record LegKind
{
    public LegKind(LimbArchetype archetype, LegOutline outline, LegBuild build, LegLimits limits, LegStep step, LegFlight flight)
    {
        Archetype = archetype;
        Outline = outline;
        Build = build;
        Limits = limits;
        Step = step;
        Flight = flight;
    }

    public LimbArchetype Archetype { get; }

    /// <summary>How it looks.</summary>
    public LegOutline Outline { get; }

    /// <summary>How it looks where it hangs and trails in the water or in the air; null for the same.</summary>
    public LegOutline? Trailing { get; init; }

    /// <summary>How it fits the body.</summary>
    public LegBuild Build { get; }

    /// <summary>How far its joints turn.</summary>
    public LegLimits Limits { get; }

    /// <summary>How it steps.</summary>
    public LegStep Step { get; }

    /// <summary>How it is held in flight.</summary>
    public LegFlight Flight { get; }
}
