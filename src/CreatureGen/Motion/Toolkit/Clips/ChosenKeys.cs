namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>The frames of a track that are kept as its keys.</summary>
internal sealed class ChosenKeys
{
    private readonly bool[] straight;

    /// <summary>Keeps frames.</summary>
    /// <param name="frames">Which, ascending.</param>
    /// <param name="straight">Whether the track goes straight from each to the next; of cubic tracks some, in others of no meaning.</param>
    public ChosenKeys(int[] frames, bool[] straight)
    {
        Frames = frames;
        this.straight = straight;
    }

    /// <summary>Which, ascending.</summary>
    public int[] Frames { get; }

    /// <summary>Number of keys.</summary>
    public int Count => Frames.Length;

    /// <summary>Whether a cubic track goes straight from a key to the next, where a curve through both and their neighbours would go astray.</summary>
    public bool GoesStraight(int key) => key >= 0 && key < straight.Length && straight[key];
}
