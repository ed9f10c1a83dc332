namespace CreatureGen.Anatomy.Legs;

/// <summary>One row of a leg or arm: where it is from the root in thousandths of the limb's length, and how thick in thousandths of its thickness.</summary>
internal readonly struct LegSection
{
    public int Forward { get; init; }

    public int Down { get; init; }

    public int Outward { get; init; }

    /// <summary>Radius along the body.</summary>
    public int ForeRadius { get; init; }

    /// <summary>Radius to the sides.</summary>
    public int SideRadius { get; init; }
}
