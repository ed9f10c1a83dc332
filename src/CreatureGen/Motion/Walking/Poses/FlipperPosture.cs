using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>Wings of a creature that waddles: held a little away from the body, the one on the side that swings farther, for balance.</summary>
internal static class FlipperPosture
{
    private const float Away = 0.28f;

    /// <summary>Radians for each leg length of difference between the feet.</summary>
    private const float Balance = 0.25f;

    private const float MaxBalance = 0.15f;

    /// <summary>Writes the roots of the wings.</summary>
    public static void Pose(LeggedBody body, RestRotations turns, BodyPlacer placer, in BodyContext context, in Pose local)
    {
        foreach (LimbChain wing in body.Flippers)
        {
            float side = wing.Side == Side.Left ? 1f : -1f;
            float balance = Scalar.Clamp(Balance * placer.Scissor * side, -MaxBalance, MaxBalance);
            turns.Set(local, wing.Joints[0], AxisRotation.Roll(side * (Away + balance) * context.Activity));
        }
    }
}
