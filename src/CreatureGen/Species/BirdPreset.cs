namespace CreatureGen.Species;

/// <summary>Proportions of a bird.</summary>
internal sealed record BirdPreset
{
    /// <summary>Height of the hip relative to the length of the torso.</summary>
    public (double Min, double Max) HipHeight { get; init; }

    /// <summary>Radius of the thigh relative to half the torso's depth.</summary>
    public (double Min, double Max) Thigh { get; init; }

    public int Toes { get; init; } = 3;

    /// <summary>Factor on the feet.</summary>
    public double Foot { get; init; } = 1;

    public double Claw { get; init; } = 0.8;

    /// <summary>Segment of the hips.</summary>
    public double HipSegment { get; init; } = 10.1;

    /// <summary>Ring that the tip of the folded wing reaches.</summary>
    public double FoldRing { get; init; } = 46;

    /// <summary>Half width of the tail's feathers, metres; 0 for a plain tail.</summary>
    public double Fan { get; init; } = 0.11;

    /// <summary>Tilt of the torso and the tail in flight, degrees.</summary>
    public (double Torso, double Tail) FlightPitch { get; init; }
}
