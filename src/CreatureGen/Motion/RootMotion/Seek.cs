using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Decides how a creature wants to move to get at a target: turn first, approach, keep its distance, back away. Nothing is allocated.</summary>
/// <remarks>
/// Angle and distance are both measured in the ground plane of the creature. Acts begin at one threshold and end at another, and speeds fall towards the end of an act in proportion to what is left, so the creature neither
/// dithers at a threshold nor stops dead; <see cref="VelocityDamping"/> smooths what is decided. Based on: WeaverDev, "Bonehead" (2018), root motion, without its full speed up to the threshold.
/// </remarks>
public static class Seek
{
    /// <summary>s⁻¹: the speed wanted is at most so many times what is left of the way.</summary>
    private const float Easing = 3f;

    // Share of the band between near and far that an act goes on into it.
    private const float IntoBand = 0.35f;

    /// <summary>The velocity that the creature wants.</summary>
    /// <param name="state">What it is about; kept by the caller.</param>
    /// <param name="settings">Its manners.</param>
    /// <param name="target">In the creature's axes, metres.</param>
    /// <exception cref="ArgumentException">The target is not finite.</exception>
    public static BodyVelocity Decide(ref SeekState state, in SeekSettings settings, Vector3 target)
    {
        Finite.Require(target, nameof(target));
        double distance = Math.Sqrt(((double)target.X * target.X) + ((double)target.Z * target.Z));
        float yaw = distance > 1e-6 ? (float)PortableMath.Atan2(target.X, target.Z) : 0f;
        float off = Math.Abs(yaw);
        state.Turning = off > settings.TurnBeyond || (state.Turning && off > settings.Facing);
        float turn = state.Turning ? Scalar.Clamp(yaw * Easing, -settings.TurnSpeed, settings.TurnSpeed) : 0f;

        float band = (settings.Far - settings.Near) * IntoBand;
        float nearer = (float)distance - (settings.Far - band);
        float farther = settings.Near + band - (float)distance;
        state.Act = distance > settings.Far || (state.Act == SeekAct.Approach && nearer > 0.02f * band) ? SeekAct.Approach
            : distance < settings.Near || (state.Act == SeekAct.Retreat && farther > 0.02f * band) ? SeekAct.Retreat
            : SeekAct.Hold;
        float aim = Scalar.Clamp(1f - (off / settings.MoveWithin), 0f, 1f);
        float ahead = state.Act switch
        {
            SeekAct.Approach => Math.Min(settings.Speed, Math.Max(nearer, 0f) * Easing) * aim,
            SeekAct.Retreat => -Math.Min(settings.Speed * settings.RetreatFraction, Math.Max(farther, 0f) * Easing) * aim,
            _ => 0f,
        };
        return new BodyVelocity(new Vector3(0f, 0f, ahead), turn);
    }
}
