namespace CreatureGen.Motion;

/// <summary>What a foot is doing.</summary>
public enum FootPhase
{
    /// <summary>On the ground, locked to where it came down.</summary>
    Stance,

    /// <summary>In the air, on its way to the next place.</summary>
    Swing,
}
