using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>The tail: it swings against the pelvis, bends into the turn, and keeps its pitch as the pelvis tips.</summary>
internal static class TailPosture
{
    private const float TurnFraction = -1.3f;

    /// <summary>How far it is swung out of a turn, against the lean of the body: radians for each of the angle at which the turn would be in balance.</summary>
    private const float Counterweight = 1.2f;

    /// <summary>Part of the pelvis's roll that the tail takes back.</summary>
    private const float Steadiness = 0.5f;

    /// <summary>How much farther than it was grown a tail with a sting is curled over the back on the way, radians, the more the nearer to its end: half curled it ends upright, a mast from the front and from behind.</summary>
    private const float CurledSting = 1.2f;

    /// <summary>Writes the tail.</summary>
    public static void Pose(LeggedBody body, RestRotations turns, BodyPlacer placer, in BodyContext context, in Pose local)
    {
        int count = body.Tail.Length;
        if (count == 0)
        {
            return;
        }

        float factor = context.Settings.Walking.TailMotion;
        Rotation.ToBasis(placer.Trunk.Turns[0], out Vector3 x, out Vector3 y, out Vector3 z);
        float pitch = (FastTrigonometry.OfSine(z.Y) * body.Posture.TailSteadiness) + (factor * body.Traits.TailLift * placer.Flexion);
        float roll = -FastTrigonometry.Of(x.Y, y.Y) * Steadiness;
        float yaw = factor * ((-body.Traits.TailYaw * placer.PelvisYaw) + (TurnFraction * placer.TurnBend) + (Counterweight * placer.Balance) + context.Idle.TailSway);
        float curl = body.Subject.HasSting ? 2 * CurledSting * Math.Min(context.Activity, 1f) / (count * Math.Max(count - 1, 1)) : 0f;
        float fraction = 1f / count;
        float lastYaw = float.NaN;
        float lastPitch = float.NaN;
        Quaternion turn = Quaternion.Identity;
        for (int i = 0; i < count; i++)
        {
            float max = StandingPosture.TailFraction * body.TailLimits[i];
            float ownYaw = Scalar.Clamp(yaw * fraction, -max, max);
            float ownPitch = Scalar.Clamp((pitch * fraction) + (curl * i), -max, max);
            if (ownYaw != lastYaw || ownPitch != lastPitch)
            {
                lastYaw = ownYaw;
                lastPitch = ownPitch;
                turn = AxisRotation.YawPitchRoll(ownYaw, ownPitch, roll * fraction);
            }

            turns.Set(local, body.Tail[i], turn);
        }
    }
}
