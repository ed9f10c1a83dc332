using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Decides how a creature wants to move to get at a target: turn first, approach, keep its distance, back away. Nothing is allocated.</summary>
/// <remarks>
/// Angle and distance are both measured in the ground plane of the creature, the distance of one that climbs in space. Acts begin at one threshold and end at another, and speeds fall towards the end of an act in proportion to what is left, so the creature neither
/// dithers at a threshold nor stops dead; <see cref="VelocityDamping"/> smooths what is decided. Based on: WeaverDev, "Bonehead" (2018), root motion, without its full speed up to the threshold.
/// </remarks>
public static class Seek
{
    // Share of the band between near and far that an act goes on into it.
    private const float IntoBand = 0.35f;

    // Part of the far end of the band within which, seen from above, a target overhead has no direction to turn to.
    private const float Overhead = 0.3f;

    /// <summary>The velocity that a creature wants that is to get at a point of the world.</summary>
    /// <param name="state">What it is about; kept by the caller.</param>
    /// <param name="settings">Its manners; <see cref="SeekSettings.For"/> knows the creature.</param>
    /// <param name="place">Where it is.</param>
    /// <param name="target">World space, metres.</param>
    /// <exception cref="ArgumentException">The target is not finite.</exception>
    public static BodyVelocity Decide(ref SeekState state, in SeekSettings settings, in RootPlace place, Vector3 target) => Decide(ref state, settings, place.ToModel(target) * place.Scale);

    /// <summary>The velocity that the creature wants; <see cref="MotionInput.From"/> asks an animator for it.</summary>
    /// <param name="state">What it is about; kept by the caller.</param>
    /// <param name="settings">Its manners.</param>
    /// <param name="target">In the creature's axes, world metres.</param>
    /// <exception cref="ArgumentException">The target is not finite.</exception>
    public static BodyVelocity Decide(ref SeekState state, in SeekSettings settings, Vector3 target)
    {
        Finite.Require(target, nameof(target));
        bool climbs = settings.ClimbSpeed > 0f;
        double planar = Math.Sqrt(((double)target.X * target.X) + ((double)target.Z * target.Z));
        double distance = climbs ? Math.Sqrt((planar * planar) + ((double)target.Y * target.Y)) : planar;
        float yaw = planar > (climbs ? Overhead * settings.Far : 1e-6) ? (float)PortableMath.Atan2(target.X, target.Z) : 0f;
        float off = Math.Abs(yaw);
        state.Turning = off > settings.TurnBeyond || (state.Turning && off > settings.Facing);
        float turn = state.Turning ? Scalar.Clamp(yaw * settings.Easing, -settings.TurnSpeed, settings.TurnSpeed) : 0f;

        float band = (settings.Far - settings.Near) * IntoBand;
        float nearer = (float)distance - (settings.Far - band);
        float farther = settings.Near + band - (float)distance;
        state.Act = distance > settings.Far || (state.Act == SeekAct.Approach && nearer > 0.02f * band) ? SeekAct.Approach
            : distance < settings.Near || (state.Act == SeekAct.Retreat && farther > 0.02f * band) ? SeekAct.Retreat
            : SeekAct.Hold;

        // Of the way that is left, each direction gets its part: who climbs goes straight to the target.
        float flat = distance > 0 ? (float)(planar / distance) : 1f;
        float aim = Scalar.Clamp(1f - (off / settings.MoveWithin), 0f, 1f);
        float approach = Math.Max(nearer, 0f) * settings.Easing;
        float retreat = Math.Max(farther, 0f) * settings.Easing;
        float ahead = state.Act switch
        {
            SeekAct.Approach => Math.Min(settings.Speed, approach * flat) * aim,
            SeekAct.Retreat => -Math.Min(settings.Speed * settings.RetreatFraction, retreat * flat) * aim,
            _ => 0f,
        };
        float rise = !climbs || distance <= 0 ? 0f : (float)(target.Y / distance);
        float climb = state.Act switch
        {
            SeekAct.Approach => approach * rise,
            SeekAct.Retreat => -retreat * rise,
            _ => 0f,
        };
        return new BodyVelocity(new Vector3(0f, Scalar.Clamp(climb, -settings.ClimbSpeed, settings.ClimbSpeed), ahead), turn);
    }
}
