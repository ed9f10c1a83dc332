namespace CreatureGen.Engines;

/// <summary>In which order an engine wants the corners of a triangle, as they are seen from outside on the screen.</summary>
public enum FrontFace
{
    /// <summary>Against the clock, as the arrays of a creature have them.</summary>
    CounterClockwise,

    /// <summary>With the clock: two corners of each triangle change places.</summary>
    Clockwise,
}
