using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Turns both eyes by what the head leaves to do. Nothing is allocated.</summary>
/// <remarks>
/// Both eyes make the same turn, that from the head's "ahead" to the direction from between the eyes to the target: so they stay parallel and never cross, and eyes at the sides of a head move together like
/// those of a horse. Each eye's turn is then brought within its own range (farther out than in) and its joint's limit by swing and twist; there are no Euler angles to break near straight up.
/// Based on: WeaverDev, "Bonehead" (2018).
/// </remarks>
public static class Eyes
{
    /// <summary>Lets time pass and poses the eyes; call it after <see cref="GazeSolver.Update"/>.</summary>
    /// <param name="rig">The joints.</param>
    /// <param name="state">Where the eyes are on their way; the same as the head's.</param>
    /// <param name="settings">How they move.</param>
    /// <param name="target">What to look at.</param>
    /// <param name="seconds">Time since the last call.</param>
    /// <param name="local">Pose in the parents' space; the eyes are turned.</param>
    /// <param name="model">The same in model space, up to date; the eyes and what hangs on them are brought up to date.</param>
    /// <exception cref="System.ArgumentException">A pose is not as long as the skeleton, or a number is not finite.</exception>
    public static void Update(GazeRig rig, ref GazeState state, in EyeSettings settings, in GazeTarget target, float seconds, in Pose local, in Pose model)
    {
        local.Require(rig.Skeleton);
        model.Require(rig.Skeleton);
        Finite.RequireStep(seconds);
        Quaternion facing = Rotation.Multiply(model.Rotations[rig.Head], rig.HeadToModel);
        LookAngles goal = default;
        if (target.Kind == GazeTargetKind.Point)
        {
            Vector3 eyes = model.Positions[rig.Head] + Rotation.Rotate(model.Rotations[rig.Head], rig.EyePoint);
            goal = LookAngles.Of(Rotation.Rotate(Rotation.Inverse(facing), target.Point - eyes), state.EyeYaw);
        }
        else if (target.Kind == GazeTargetKind.Direction)
        {
            Quaternion trunk = Rotation.Multiply(model.Rotations[rig.Base], rig.BaseToModel);
            Vector3 direction = Rotation.Rotate(trunk, Rotation.Rotate(target.Angles.Turn(), Vector3.UnitZ));
            goal = LookAngles.Of(Rotation.Rotate(Rotation.Inverse(facing), direction), state.EyeYaw);
        }

        float widest = settings.Left.Max > -settings.Left.Min ? settings.Left.Max : -settings.Left.Min;
        goal = new LookAngles(Scalar.Clamp(goal.Yaw, -widest, widest), settings.Pitch.Clamp(goal.Pitch));
        float left = Damping.Left(settings.Rate, seconds);
        state.EyeYaw = Scalar.Lerp(goal.Yaw, state.EyeYaw, left);
        state.EyePitch = Scalar.Lerp(goal.Pitch, state.EyePitch, left);
        Place(rig, rig.LeftEye, settings.Left, state, settings, local, model);
        Place(rig, rig.RightEye, settings.Left.Negated, state, settings, local, model);
    }

    private static void Place(GazeRig rig, int eye, AngleRange yaw, in GazeState state, in EyeSettings settings, in Pose local, in Pose model)
    {
        if (eye < 0)
        {
            return;
        }

        // Pitch up is a negative turn about X.
        double x = -state.EyePitch;
        double y = state.EyeYaw;
        SwingTwistLimit.ClampSwing(settings.Pitch.Negated, yaw, ref x, ref y);
        Joint joint = rig.Skeleton.AllJoints[eye];
        Quaternion atRest = Rotation.Multiply(rig.HeadToModel, rig.Skeleton.ModelRotations[eye]);
        Quaternion turn = new LookAngles((float)y, (float)-x).Turn();
        Quaternion inHead = Rotation.Multiply(rig.HeadToModel, Rotation.Multiply(turn, Rotation.Inverse(rig.HeadToModel)));
        local.Rotations[eye] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(Rotation.Multiply(inHead, atRest)), joint);
        Subtree.LocalToModel(rig.Skeleton, eye, local, model);
    }
}
