namespace CreatureGen.Anatomy.Legs;

/// <summary>How a leg is held in flight.</summary>
internal sealed class LegFlight
{
    public LegFlight(LegPosture tucked, LegPosture hanging, LegPosture reaching)
    {
        Tucked = tucked;
        Hanging = hanging;
        Reaching = reaching;
        Foremost = tucked;
        Midmost = tucked;
        Hindmost = tucked;
    }

    /// <summary>Folded under the body in flight.</summary>
    public LegPosture Tucked { get; }

    /// <summary>The same of the first of several pairs of a kind. Pairs that are all held alike lie in a row along the belly and are seen as one heap.</summary>
    public LegPosture Foremost { get; init; }

    /// <summary>The same half-way between the first and the last of them.</summary>
    public LegPosture Midmost { get; init; }

    /// <summary>The same of the last of them.</summary>
    public LegPosture Hindmost { get; init; }

    /// <summary>Hanging loosely when it stands in the air.</summary>
    public LegPosture Hanging { get; }

    /// <summary>Stretched towards the ground before it touches down.</summary>
    public LegPosture Reaching { get; }

    /// <summary>Folded in flight, of one of several pairs of a kind.</summary>
    /// <param name="place">From 0 for the first to 1 for the last.</param>
    public LegPosture InRow(double place) => place < 0.5 ? LegPosture.Between(Foremost, Midmost, 2 * place) : LegPosture.Between(Midmost, Hindmost, (2 * place) - 1);
}
