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

    /// <summary>How far ahead of its bone the middle of the flesh is, in thousandths of the limb's thickness: calves, elbows and heels are behind it.</summary>
    public int ForeOffset { get; init; }

    /// <summary>How far outside of its bone the middle of the flesh is, in the same.</summary>
    public int SideOffset { get; init; }
}
