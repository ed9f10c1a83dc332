namespace CreatureGen.Motion.Falling;

/// <summary>How far a body was lifted out of the ground, metres of the model.</summary>
/// <param name="OfLimbs">For its trunk and limbs.</param>
/// <param name="OfEnds">After that, for what of head and tail could not be bent up out of it.</param>
internal readonly record struct Clearing(float OfLimbs, float OfEnds);
