namespace CreatureGen.Motion;

/// <summary>Which way a startled fish darts.</summary>
public enum EscapeTurn
{
    /// <summary>It does not.</summary>
    None,

    /// <summary>To its left.</summary>
    Left,

    /// <summary>To its right.</summary>
    Right,
}
