namespace CreatureGen.Motion.Winged;

/// <summary>One moment of a flier's motion, as its wings see it.</summary>
internal struct WingStroke
{
    /// <summary>Beats; only the fraction counts.</summary>
    public double Phase;

    /// <summary>Width of the beat, 1 at cruise.</summary>
    public double Amplitude;

    /// <summary>0 beating, 1 gliding.</summary>
    public double Glide;

    /// <summary>0 folded, 1 spread.</summary>
    public double Spread;

    /// <summary>0 held for flight, 1 as one carries them who goes on legs.</summary>
    public double Carried;

    /// <summary>How far wings are raised to be seen, on top; 1 high.</summary>
    public double Shown;

    /// <summary>0..1, spread against the air to slow down.</summary>
    public double Flare;

    /// <summary>−1..1, positive in a turn to the left.</summary>
    public double Steer;

    /// <summary>0..1, how much it stands in the air.</summary>
    public double Hover;

    /// <summary>−1..1, a slow swing.</summary>
    public double Drift;

    /// <summary>How far the body is above where it stands, metres.</summary>
    public double Altitude;

    /// <summary>How far folded wings are off the flank, radians.</summary>
    public double LiftLeft;

    /// <inheritdoc cref="LiftLeft"/>
    public double LiftRight;
}
