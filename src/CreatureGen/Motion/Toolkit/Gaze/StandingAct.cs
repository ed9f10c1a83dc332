namespace CreatureGen.Motion.Toolkit.Gaze;

/// <summary>What lids and ears of a creature are at.</summary>
/// <param name="Lids">How far the lids are shut, 0 as at rest to 1.</param>
/// <param name="LeftEar">How far the left ear is flicked, 0..1.</param>
/// <param name="RightEar">The same of the right ear.</param>
internal readonly record struct StandingAct(float Lids, float LeftEar, float RightEar);
