namespace CreatureGen.Motion.Swimming;

/// <summary>What a swimmer is to do.</summary>
/// <param name="Speed">Metres per second along its nose; negative backs up.</param>
/// <param name="YawRate">Radians per second; positive turns left.</param>
/// <param name="ClimbRate">Metres per second up.</param>
/// <param name="Escape">A change from <see cref="EscapeTurn.None"/> starts a C-start: the body curls up to one side, then darts off with a beat to the other.</param>
/// <param name="Settings">How it swims; null for the defaults.</param>
/// <param name="Room">Metres that it may sink by; negative where it has to rise.</param>
internal readonly record struct SwimInput(float Speed, float YawRate = 0f, float ClimbRate = 0f, EscapeTurn Escape = EscapeTurn.None, SwimmingSettings? Settings = null, float Room = float.PositiveInfinity);
