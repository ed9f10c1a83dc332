namespace CreatureGen.Motion.Falling;

/// <summary>How a trunk is heaved up, metres of the model.</summary>
/// <param name="Fore">Where its fore legs hang.</param>
/// <param name="Hind">Where its hind legs hang.</param>
/// <param name="Raised">All of it.</param>
/// <param name="Pitch">Nose up, radians.</param>
internal readonly record struct Heaved(float Fore, float Hind, float Raised, float Pitch);
