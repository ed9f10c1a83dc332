namespace CreatureGen.Motion;

/// <summary>How a creature without legs crawls.</summary>
public enum SlitherGait
{
    /// <summary>Lateral undulation: the whole body slides along the winding track of the head.</summary>
    Undulating,

    /// <summary>The body lies aslant to its way; parts of it rest on the ground while the others are lifted and laid down ahead (loose sand).</summary>
    Sidewinding,

    /// <summary>Straight on, by waves of the belly (heavy snakes, narrow places).</summary>
    Rectilinear,
}
