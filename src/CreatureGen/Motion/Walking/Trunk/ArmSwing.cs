using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>Arms swing against the leg of their side, and bend as it gets faster.</summary>
internal static class ArmSwing
{
    private const float SwingPerScissor = 0.68f;
    private const float CarriedSwing = 0.10f;

    /// <summary>Radians that both arms are thrown up for each that the trunk is.</summary>
    private const float ThrowPerRock = 2.5f;

    private const float Forearm = 0.25f;
    private const float Wrist = 0.3f;

    /// <summary>Writes the arms.</summary>
    public static void Pose(LeggedBody body, RestRotations turns, BodyPlacer placer, in BodyContext context, in Pose local)
    {
        foreach (ArmShape arm in body.Arms)
        {
            float side = arm.Side == Side.Left ? -1f : 1f;
            float size = body.IsBiped ? SwingPerScissor : CarriedSwing;
            float swing = Scalar.Clamp(size * placer.Scissor * side, -0.7f, 0.7f) * context.Activity;
            float bend = (Forearm * (swing > 0f ? swing : 0f)) + (context.Clock.Shape.ElbowBend * 0.5f * context.Activity);
            swing += ThrowPerRock * placer.Rock;
            turns.Set(local, arm.Shoulder, AxisRotation.Pitch(-swing));
            turns.Set(local, arm.Elbow, AxisRotation.Pitch(-bend));
            turns.Set(local, arm.Wrist, AxisRotation.Pitch(Wrist * swing));
        }
    }
}
