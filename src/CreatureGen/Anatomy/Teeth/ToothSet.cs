namespace CreatureGen.Anatomy.Teeth;

/// <summary>Teeth of one form that stand side by side along a stretch of a lip. Heights are in lengths of the longest tooth of the mouth.</summary>
internal sealed record ToothSet
{
    /// <summary>Where the stretch begins and ends, as shares of the way along the lip from the middle of the front to the corner.</summary>
    public (float From, float To) Stretch { get; init; }

    /// <summary>How many there are on one side.</summary>
    public int Count { get; init; } = 1;

    /// <summary>Height of the first and of the last one.</summary>
    public (float First, float Last) Height { get; init; } = (1f, 1f);

    /// <summary>Factor on the height of each second one.</summary>
    public float Second { get; init; } = 1f;

    /// <summary>Breadth along the lip, as a share of the room that each of them has.</summary>
    public float Fill { get; init; } = 0.7f;

    /// <summary>Greatest breadth, in heights of the tooth.</summary>
    public float Stoutest { get; init; } = 0.6f;

    /// <summary>Thickness across the lip, in breadths.</summary>
    public float Depth { get; init; } = 0.8f;

    /// <summary>Breadth of the edge that it ends in, in breadths of its root; 0 for a point.</summary>
    public float Edge { get; init; }

    /// <summary>How far its end leans into the mouth, in heights.</summary>
    public float Curve { get; init; }
}
