using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What the limits of the hip of a leg let it reach, without a pose: the trunk is taken to be turned as it was when the leg was last posed.</summary>
internal static class HipRoom
{
    /// <summary>Distance by which the leg would miss a place, its foot straight ahead, metres.</summary>
    /// <param name="body">Whose leg it is.</param>
    /// <param name="leg">The leg.</param>
    /// <param name="carrier">Turn of the trunk at its hip from rest.</param>
    /// <param name="chord">From its hip to the place, model space.</param>
    public static float Miss(LeggedBody body, LegRig leg, Quaternion carrier, Vector3 chord) =>
        IsFree(body, leg, carrier, chord, Quaternion.Identity, out LegRotations solved) ? solved.Residual : Vec.Distance(LegSolver.EndOf(leg, leg.Parts, solved), chord);

    /// <summary>Where the leg would end that reaches for a place, from its hip, model space: there, where its hip turns as far as it takes.</summary>
    /// <param name="body">Whose leg it is.</param>
    /// <param name="leg">The leg.</param>
    /// <param name="carrier">Turn of the trunk at its hip from rest.</param>
    /// <param name="chord">From its hip to the place, model space.</param>
    /// <param name="heading">Turn of its foot from rest, model space.</param>
    public static Vector3 Nearest(LeggedBody body, LegRig leg, Quaternion carrier, Vector3 chord, Quaternion heading) =>
        IsFree(body, leg, carrier, chord, heading, out LegRotations solved) ? chord : LegSolver.EndOf(leg, leg.Parts, solved);

    /// <summary>Whether the hip turns as far as it is asked; the leg as it lets it be.</summary>
    private static bool IsFree(LeggedBody body, LegRig leg, Quaternion carrier, Vector3 chord, Quaternion heading, out LegRotations solved)
    {
        LegSolver.Solve(leg, leg.Parts, chord, LegSolver.Side(leg, carrier, chord, heading, 0f), 0f, 0f, Vector3.Zero, out solved);
        Quaternion asked = body.Turns.Local(leg.Hip, Rotation.Multiply(Rotation.Inverse(carrier), solved.Thigh));
        Quaternion kept = leg.Limits.Hip.Clamp(asked);
        if (kept == asked)
        {
            return true;
        }

        solved.Thigh = Rotation.Multiply(carrier, body.Turns.Of(leg.Hip, kept));
        solved.Shank = Rotation.Multiply(solved.Thigh, solved.Knee);
        LegSolver.Bend(leg, leg.Parts, chord, 0f, ref solved);
        return false;
    }
}
