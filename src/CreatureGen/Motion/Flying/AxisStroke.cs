namespace CreatureGen.Motion.Flying;

/// <summary>One moment of a flier's motion, as its neck and tail see it.</summary>
internal struct AxisStroke
{
    /// <summary>Pitch of the body, radians, positive nose down.</summary>
    public double Pitch;

    /// <summary>Roll of the body, radians, positive left side up.</summary>
    public double Roll;

    /// <summary>How far the head turns, radians, positive left.</summary>
    public double Look;

    /// <summary>−1..1, positive in a turn to the left.</summary>
    public double Steer;

    /// <summary>−1..1, positive climbing.</summary>
    public double Rise;

    /// <summary>0 still air, 1 the stream of cruise.</summary>
    public double Stream;

    /// <summary>0..1.</summary>
    public double Hover;

    /// <summary>Beats.</summary>
    public double Phase;

    /// <summary>How much the wings beat, 0..1.</summary>
    public double Beat;
}
