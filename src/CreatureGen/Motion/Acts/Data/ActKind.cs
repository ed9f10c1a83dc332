
namespace CreatureGen.Motion;

/// <summary>What an act is for.</summary>
public enum ActKind
{
    /// <summary>A fright: at once, and over soon.</summary>
    Reflex,

    /// <summary>An attack.</summary>
    Strike,

    /// <summary>Something shown to others.</summary>
    Display,

    /// <summary>Eating, drinking, grooming.</summary>
    Upkeep,

    /// <summary>Sitting, lying: until told to go on.</summary>
    Posture,
}
