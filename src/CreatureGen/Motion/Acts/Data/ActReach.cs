namespace CreatureGen.Motion;

/// <summary>How far an act reaches on level ground, straight ahead of the creature unless it says otherwise. Model space: metres from the root, at scale 1.</summary>
/// <param name="Nearest">Least distance ahead at which it meets a target at the usual height.</param>
/// <param name="Farthest">Greatest of them.</param>
/// <param name="Lowest">Least height at the usual distance.</param>
/// <param name="Highest">Greatest of them.</param>
/// <param name="Aside">How far to either side at the usual height and distance.</param>
public readonly record struct ActReach(float Nearest, float Farthest, float Lowest, float Highest, float Aside);
