namespace CreatureGen.Motion;

/// <summary>A gait in a creature's order from slow to fast.</summary>
/// <param name="Gait">The gait.</param>
/// <param name="Enter">Froude number above which it takes over from the one before.</param>
/// <param name="Leave">Froude number below which it gives way to the one before; less than <paramref name="Enter"/>, so that the gait does not flutter.</param>
public readonly record struct GaitStep(Gait Gait, float Enter, float Leave);
