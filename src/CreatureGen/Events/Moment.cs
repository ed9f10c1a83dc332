namespace CreatureGen.Events;

/// <summary>The greatest acceleration of a stretch above the threshold.</summary>
/// <param name="Curve">Number of the curve.</param>
/// <param name="Time">Seconds.</param>
/// <param name="Strength">The acceleration there, in thresholds.</param>
internal readonly record struct Moment(int Curve, float Time, float Strength);
