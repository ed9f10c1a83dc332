using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>A foot that turns on a point of its sole where its joints turn it: on its middle, or on the tip of its toes as it rolls off. So does one that follows its leg, or stands aslant for all of its stance.</summary>
internal static class SolePivot
{
    /// <summary>Pitch at which a foot stands on nothing but the tip of its toes, radians.</summary>
    private const float Rolled = 0.2f;

    /// <summary>How far the ball has to go for that point to stay where it was.</summary>
    /// <param name="leg">Gives the sole.</param>
    /// <param name="wanted">Turn of the toes from rest as they should lie.</param>
    /// <param name="allowed">The same as their joint allows.</param>
    /// <param name="pitch">Of what it stands on, radians, toes down.</param>
    public static Vector3 Way(LegRig leg, Quaternion wanted, Quaternion allowed, float pitch)
    {
        Vector3 tip = leg.ToeDirection * (leg.Toe - Vec.Dot(leg.SoleMiddle, leg.ToeDirection));
        Vector3 pivot = leg.SoleMiddle + (tip * Scalar.Smooth(pitch / Rolled)) - new Vector3(0f, leg.BallHeight, 0f);
        return Rotation.Rotate(wanted, pivot) - Rotation.Rotate(allowed, pivot);
    }
}
