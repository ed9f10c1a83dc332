namespace CreatureGen.Anatomy.Legs;

/// <summary>How a leg is held in flight.</summary>
internal sealed class LegFlight
{
    public LegFlight(LegPosture tucked, LegPosture hanging, LegPosture reaching)
    {
        Tucked = tucked;
        Hanging = hanging;
        Reaching = reaching;
    }

    /// <summary>Folded under the body in flight.</summary>
    public LegPosture Tucked { get; }

    /// <summary>Hanging loosely when it stands in the air.</summary>
    public LegPosture Hanging { get; }

    /// <summary>Stretched towards the ground before it touches down.</summary>
    public LegPosture Reaching { get; }
}
