namespace CreatureGen.Motion.Walking.Idle;

/// <summary>What a standing body does by itself.</summary>
/// <param name="Breath">Rise of the trunk, metres.</param>
/// <param name="Shift">Shift of the weight to the left, metres.</param>
/// <param name="Roll">Roll of the pelvis with it, radians.</param>
/// <param name="Yaw">Yaw of the pelvis with it, radians.</param>
/// <param name="TailSway">Yaw of the tail, radians.</param>
/// <param name="Wings">How far folded wings are off the flank, radians.</param>
/// <param name="Rest">How far the right hind foot, off which the weight has gone, rests on the tip of its toes, 0..1.</param>
internal readonly record struct IdlePose(float Breath, float Shift, float Roll, float Yaw, float TailSway, float Wings, float Rest);
