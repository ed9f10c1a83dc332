namespace CreatureGen.Motion.Acts.Data;

/// <summary>A side on which a body comes to lie that rolls over off its belly: acts go there, and how far it rolls over is found there.</summary>
/// <param name="Nearest">How far it rolls over at the least, radians.</param>
/// <param name="Farthest">How far at most, radians.</param>
/// <param name="MaxRise">How much higher than on its belly it may lie, as a factor.</param>
/// <param name="Down">How far chest and hips are down over legs that are stretched out, parts of the belly's height.</param>
/// <param name="AwayFromFeet">How far the trunk is away from feet that hang together beside it, parts of the leg.</param>
internal sealed record LyingSide(float Nearest, float Farthest, float MaxRise, float Down, float AwayFromFeet)
{
    /// <summary>How far feet hang with their toes down, radians.</summary>
    public const float ToesDown = 0.6f;

    /// <summary>How far chest and hips are down, parts of the belly's height, as a body rolls over onto its back with its legs drawn in.</summary>
    public const float DownAsItTurns = 0.9f;

    /// <summary>On a flank, with legs stretched out.</summary>
    public static readonly LyingSide Flank = new(1.1f, 1.67f, 1.3f, 0.25f, 0f);

    /// <summary>On the back, with the feet together above it: knees that stand out beside a body would be below it otherwise. Shells and low crests carry it higher than a belly does; it does not stand on a sail, or on knees.</summary>
    public static readonly LyingSide Back = new(2.65f, 3.17f, 1.6f, 0f, 0.35f);
}
