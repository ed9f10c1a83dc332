namespace CreatureGen.Motion.Flying;

/// <summary>What a flier is doing between standing and flying.</summary>
internal enum FlightPhase
{
    /// <summary>It stands or walks, with folded wings.</summary>
    Grounded,

    /// <summary>It crouches and raises its wings.</summary>
    Crouching,

    /// <summary>It leaps and beats its wings for the first time.</summary>
    Leaping,

    /// <summary>It flies.</summary>
    Airborne,

    /// <summary>It comes down: pitched up, wings against the air, legs ahead.</summary>
    Landing,

    /// <summary>Its feet are down; it gives in at the knees, stands up and folds its wings.</summary>
    Settling,
}
