namespace CreatureGen.Motion;

/// <summary>A gait of a creature and the speeds it is for, metres per second.</summary>
/// <param name="Gait">The gait.</param>
/// <param name="Slowest">Below it the creature falls back into the gait before.</param>
/// <param name="Comfortable">The speed that suits it best.</param>
/// <param name="Fastest">Beyond it the creature goes over into the next gait, or goes no faster.</param>
public readonly record struct GaitSpeed(Gait Gait, float Slowest, float Comfortable, float Fastest);
