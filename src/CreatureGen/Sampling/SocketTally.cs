namespace CreatureGen.Sampling;

/// <summary>How the sockets of one creature were given out on the cells of its body.</summary>
public readonly struct SocketTally
{
    internal SocketTally(int limbRefusals, int ornamentRefusals, int takenCells)
    {
        LimbRefusals = limbRefusals;
        OrnamentRefusals = ornamentRefusals;
        TakenCells = takenCells;
    }

    /// <summary>Legs, arms, wings and fins whose socket ran into another one's cells when it was reserved. The attachment rules leave none.</summary>
    public int LimbRefusals { get; }

    /// <summary>Ears that were left out for want of room.</summary>
    public int OrnamentRefusals { get; }

    /// <summary>Cells of the body that became sockets, on both sides, of 54 × 32.</summary>
    public int TakenCells { get; }
}
