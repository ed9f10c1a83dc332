using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>Neck and head: they take back most of the chest's turns, so that the gaze stays level, nod with the chest's rise, look into the turn, and bob in walking birds.</summary>
internal static class HeadPosture
{
    /// <summary>Part of what a neck is stretched ahead that the head takes back; and what of it a head without a neck shows.</summary>
    private const float HeadLevel = 0.8f;
    private const float LoneHead = 0.5f;

    /// <summary>How far a joint of it turns for that at most, part of how far it bends.</summary>
    private const float MaxReach = 0.6f;

    private const float BobHold = 0.55f;

    /// <summary>Writes neck and head.</summary>
    public static void Pose(LeggedBody body, RestRotations turns, BodyPlacer placer, in BodyContext context, in Pose local)
    {
        int count = body.Neck.Length;
        if (count == 0)
        {
            return;
        }

        Quaternion chest = placer.Trunk.Turns[placer.Trunk.Turns.Length - 1];
        Rotation.ToBasis(chest, out Vector3 x, out Vector3 y, out Vector3 z);
        float steady = body.Traits.HeadSteadiness * context.Settings.Walking.HeadSteadiness;
        float yaw = (-FastTrigonometry.Of(z.X, z.Z) * steady) + placer.TurnLook;
        float pitch = (FastTrigonometry.OfSine(z.Y) - (body.Posture.Raised * context.Upright)) * steady;
        float roll = -FastTrigonometry.Of(x.Y, y.Y) * steady;
        float fraction = 1f / count;
        float nod = placer.Nod;
        float bob = Bob(body, context);
        float lastTilt = float.NaN;
        float lastYaw = float.NaN;
        Quaternion turn = Quaternion.Identity;
        for (int i = 0; i < count; i++)
        {
            bool head = i == count - 1;
            float tilt = (pitch * fraction) + (head ? -0.9f * 1.3f * nod * (count - 1) * fraction : 1.3f * nod * fraction);
            if (bob != 0f && count >= 2)
            {
                tilt += i == 0 ? bob : i == count - 2 ? -0.35f * bob : head ? -0.65f * bob : 0f;
            }

            tilt = Scalar.Clamp(tilt, -body.NeckLimits[i], body.NeckLimits[i]) + (context.Upright * body.Posture.Nod(i));
            float reach = placer.NeckReach * (!head ? 1f / (count - 1) : count == 1 ? LoneHead : -HeadLevel);
            float most = MaxReach * body.NeckLimits[i];
            tilt = Scalar.Clamp(tilt + reach, Math.Min(tilt, -most), Math.Max(tilt, most));
            float aside = Scalar.Clamp(yaw * fraction, -body.NeckTurns[i], body.NeckTurns[i]);
            if (tilt != lastTilt || aside != lastYaw)
            {
                lastTilt = tilt;
                lastYaw = aside;
                turn = AxisRotation.YawPitchRoll(aside, tilt, roll * fraction);
            }

            turns.Set(local, body.Neck[i], turn);
        }
    }

    /// <summary>The head stays in place while the body goes on under it, then thrusts ahead: twice in a cycle.</summary>
    private static float Bob(LeggedBody body, in BodyContext context)
    {
        float size = body.Traits.HeadBob;
        if (size == 0f || context.Clock.Gait.Symmetry == GaitSymmetry.Leading || context.Clock.Duty < 0.5f)
        {
            return 0f;
        }

        double twice = 2 * context.Clock.Phase;
        float x = (float)(twice - Math.Floor(twice));
        float at = x < BobHold ? (x / BobHold) - 0.5f : 0.5f - Scalar.Smooth((x - BobHold) / (1f - BobHold));
        return -size * at * context.Activity;
    }
}
