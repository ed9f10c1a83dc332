namespace CreatureGen.Inspection;

/// <summary>A promise that a creature does not keep.</summary>
/// <param name="Invariant">One of <see cref="CreatureInspection.Invariants"/>.</param>
/// <param name="Detail">What was found, where, and what was expected.</param>
public sealed record InvariantViolation(string Invariant, string Detail);
