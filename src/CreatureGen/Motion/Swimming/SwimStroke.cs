namespace CreatureGen.Motion.Swimming;

/// <summary>One moment of a swimmer's motion, as its fins see it.</summary>
internal struct SwimStroke
{
    /// <summary>Cycles.</summary>
    public double Phase;

    /// <summary>Width of the beat, 1 at cruise.</summary>
    public double Amplitude;

    /// <summary>Of the body's wave, body lengths.</summary>
    public double Wavelength;

    /// <summary>1 for a body that beats from side to side, 0 for one that beats up and down.</summary>
    public double Sideways;

    /// <summary>1 standing still in the water, 0 from half the speed of cruise on.</summary>
    public double Hover;

    /// <summary>0 up to the speed of cruise, 1 at twice that speed.</summary>
    public double Fast;

    /// <summary>0 legs paddle, 1 they are laid back along the flanks: from 0.85 of the speed of cruise on, and in a C-start.</summary>
    public double Trail;

    /// <summary>−1..1, positive in a turn to the left.</summary>
    public double Steer;

    /// <summary>−1..1, positive when climbing.</summary>
    public double Rise;

    /// <summary>0..1, how hard it slows down.</summary>
    public double Brake;

    /// <summary>0..1, how hard it backs up.</summary>
    public double Back;

    /// <summary>1 drawn up to push off out of rest, negative in the stroke that follows.</summary>
    public double Push;
}
