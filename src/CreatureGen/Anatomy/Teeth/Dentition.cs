namespace CreatureGen.Anatomy.Teeth;

/// <summary>The teeth of a kind of animals as data.</summary>
internal sealed record Dentition
{
    /// <summary>Those of the upper jaw.</summary>
    public ToothSet[] Upper { get; init; } = System.Array.Empty<ToothSet>();

    /// <summary>Those of the lower jaw.</summary>
    public ToothSet[] Lower { get; init; } = System.Array.Empty<ToothSet>();

    /// <summary>Whether teeth stand on the edge of the lips, where they are seen when the mouth is shut, and not behind it.</summary>
    public bool Bared { get; init; }

    /// <summary>Height of the gum that is seen between lip and teeth, in lengths of the longest tooth.</summary>
    public float Gum { get; init; } = 0.3f;
}
