namespace CreatureGen.Animation.Strokes;

/// <summary>How the root moves while a motion plays, in its own axes.</summary>
/// <param name="Forward">Metres per second ahead (+Z).</param>
/// <param name="Up">Metres per second up (+Y).</param>
/// <param name="YawRate">Radians per second about +Y; positive turns left.</param>
public readonly record struct RootVelocity(float Forward, float Up, float YawRate);
