namespace CreatureGen.Anatomy;

/// <summary>One of the two jaws.</summary>
internal enum Jaw
{
    /// <summary>That of the head.</summary>
    Upper,

    /// <summary>That which turns.</summary>
    Lower,
}
