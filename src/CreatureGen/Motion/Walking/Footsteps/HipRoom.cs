using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How far the limits of a hip keep a leg from a place, without a pose: the trunk is taken for level and unbent.</summary>
internal static class HipRoom
{
    /// <summary>Distance by which the leg would miss the place, metres.</summary>
    /// <param name="body">Whose leg it is.</param>
    /// <param name="leg">The leg.</param>
    /// <param name="chord">From its hip to the place, model space.</param>
    /// <param name="heading">Of its foot, model space.</param>
    public static float Miss(LeggedBody body, LegRig leg, Vector3 chord, Quaternion heading)
    {
        LegSolver.Solve(leg, leg.Parts, chord, LegSolver.Side(leg, Quaternion.Identity, chord, heading), 0f, 0f, out LegRotations solved);
        Quaternion asked = body.Turns.Local(leg.Hip, solved.Thigh);
        Quaternion kept = SwingTwistLimit.ClampLocal(asked, leg.HipJoint);
        if (kept == asked)
        {
            return solved.Residual;
        }

        solved.Thigh = body.Turns.Of(leg.Hip, kept);
        LegSolver.Bend(leg, leg.Parts, chord, 0f, ref solved);
        return Vec.Distance(LegSolver.EndOf(leg, leg.Parts, solved), chord);
    }
}
