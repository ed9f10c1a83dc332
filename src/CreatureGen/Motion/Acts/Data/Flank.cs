namespace CreatureGen.Motion.Acts.Data;

/// <summary>How a body lies on its flank: acts go there, and how far it rolls over is found there.</summary>
internal static class Flank
{
    /// <summary>How far chest and hips are down over legs that are stretched out, parts of the belly's height.</summary>
    public const float Down = 0.25f;

    /// <summary>How far feet hang with their toes down, radians.</summary>
    public const float ToesDown = 0.6f;
}
