namespace CreatureGen.Sampling.Placement;

/// <summary>How small and how large the socket of a limb may be, in cells, and how much room it keeps around it.</summary>
/// <param name="MinimumRows">Fewest cells along the body, even.</param>
/// <param name="MaximumRows">Most cells along the body, even.</param>
/// <param name="MinimumColumns">Fewest cells around the body, even.</param>
/// <param name="MaximumColumns">Most cells around the body, even.</param>
/// <param name="Pad">Rings of cells before and behind the socket that no other socket may take.</param>
internal sealed record SocketBounds(int MinimumRows, int MaximumRows, int MinimumColumns, int MaximumColumns, int Pad)
{
    /// <summary>Legs and arms of vertebrates.</summary>
    public static SocketBounds Limb { get; } = new(MinimumRows: 4, MaximumRows: 8, MinimumColumns: 4, MaximumColumns: 6, Pad: 1);

    /// <summary>Short legs in a row, and arms of insects.</summary>
    public static SocketBounds Short { get; } = new(MinimumRows: 4, MaximumRows: 4, MinimumColumns: 4, MaximumColumns: 4, Pad: 0);

    /// <summary>Legs of insects: always two by two cells.</summary>
    public static SocketBounds Insect { get; } = new(MinimumRows: 2, MaximumRows: 2, MinimumColumns: 2, MaximumColumns: 2, Pad: 0);
}
