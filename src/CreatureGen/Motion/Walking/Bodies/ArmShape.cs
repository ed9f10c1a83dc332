using CreatureGen.Anatomy;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>An arm that swings as its body walks.</summary>
internal readonly record struct ArmShape(int Shoulder, int Elbow, int Wrist, Side Side);
