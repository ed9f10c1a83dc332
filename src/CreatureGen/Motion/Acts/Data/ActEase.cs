namespace CreatureGen.Motion;

/// <summary>How a phase goes from the values before it to its own; x is 0..1.</summary>
public enum ActEase
{
    /// <summary>From rest to rest: x³(10 − 15x + 6x²).</summary>
    Smooth,

    /// <summary>From rest to full speed: x².</summary>
    In,

    /// <summary>From full speed to rest: 1 − (1 − x)³.</summary>
    Out,

    /// <summary>Past its end and back to it: 1 + 2.4(x − 1)³ + 1.4(x − 1)².</summary>
    Over,
}
