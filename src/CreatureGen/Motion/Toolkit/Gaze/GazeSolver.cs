using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Turns head and neck to what a creature looks at, on top of any motion. Nothing is allocated.</summary>
/// <remarks>
/// <para>The direction to the target is measured in the frame of the trunk that carries the neck, as yaw and pitch, bounded, and approached by a critically damped spring; when the trunk turns below it, the head keeps its direction in model space and is brought back within its bounds by the spring. The turn from where the motion points
/// the head to there, T = R(yaw, pitch) · R(yaw of the motion, pitch of the motion)⁻¹, adds no roll and keeps the roll of the motion. Joint i of the chain is brought to T^cᵢ times its own model rotation, cᵢ rising
/// to 1 at the head; each stays within its <see cref="JointLimit"/>, and what one cannot take the next ones do.</para>
/// <para>A target behind is looked at over the nearer shoulder, and over the same one while it is near straight behind. With no target the turn fades out, starting and ending smoothly; it comes back from where the motion is.</para>
/// <para>Based on: WeaverDev, "Bonehead" (2018), for damping and limits; ozz-animation's look-at sample (G. Blanc), for a turn spread over a chain.</para>
/// </remarks>
public static class GazeSolver
{
    /// <summary>Attention below which it is gone: a thousandth of a turn of the head cannot be seen.</summary>
    private const float MinAttention = 1e-3f;
    private const int MaxJoints = 64;

    /// <summary>Lets time pass and poses head and neck.</summary>
    /// <param name="rig">The joints.</param>
    /// <param name="state">Where the head is on its way; kept by the caller.</param>
    /// <param name="settings">How it moves.</param>
    /// <param name="target">What to look at.</param>
    /// <param name="seconds">Time since the last call; 0 poses again without moving on.</param>
    /// <param name="local">The motion's pose in the parents' space; the chain's joints are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the lowest joint outwards.</param>
    /// <returns>Radians between where the head points now and the target; 0 with no target.</returns>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, or a number is not finite.</exception>
    public static float Update(GazeRig rig, ref GazeState state, in GazeSettings settings, in GazeTarget target, float seconds, in Pose local, in Pose model)
    {
        LookAngles goal = Advance(rig, ref state, settings, target, seconds, local, model);
        if (target.Kind == GazeTargetKind.None)
        {
            return 0f;
        }

        Vector3 posed = Ahead(rig, ToTrunk(rig, model), model);
        return (float)Rotation.Angle(Rotation.FromTo(posed, Rotation.Rotate(goal.Turn(), Vector3.UnitZ)));
    }

    /// <summary>The same; says where the target is seen from the trunk.</summary>
    internal static LookAngles Advance(GazeRig rig, ref GazeState state, in GazeSettings settings, in GazeTarget target, float seconds, in Pose local, in Pose model)
    {
        local.Require(rig.Skeleton);
        model.Require(rig.Skeleton);
        Finite.RequireStep(seconds);
        ReadOnlySpan<int> joints = rig.Joints;
        if (joints.Length > MaxJoints)
        {
            throw new ArgumentException(FormattableString.Invariant($"{joints.Length} joints; expected at most {MaxJoints}"), nameof(rig));
        }

        Span<Quaternion> motion = stackalloc Quaternion[joints.Length];
        for (int i = 0; i < joints.Length; i++)
        {
            motion[i] = local.Rotations[joints[i]];
        }

        Quaternion toTrunk = ToTrunk(rig, model);
        LookAngles animated = LookAngles.Of(Ahead(rig, toTrunk, model), 0f);
        if (state.Attention == 0f)
        {
            state.Yaw = animated.Yaw;
            state.Pitch = animated.Pitch;
            state.YawVelocity = 0f;
            state.PitchVelocity = 0f;
        }
        else if (toTrunk != state.ToTrunk)
        {
            // A trunk that swings does not take the gaze along.
            Vector3 kept = Rotation.Rotate(Rotation.Inverse(state.ToTrunk), Rotation.Rotate(new LookAngles(state.Yaw, state.Pitch).Turn(), Vector3.UnitZ));
            LookAngles seen = LookAngles.Of(Rotation.Rotate(toTrunk, kept), state.Yaw);
            state.Yaw = seen.Yaw;
            state.Pitch = seen.Pitch;
        }

        state.ToTrunk = toTrunk;

        // The eyes move with the head, so the direction is measured where the head was going to be.
        float attention = 0f;
        LookAngles goal = new(state.Yaw, state.Pitch);
        if (target.Kind == GazeTargetKind.Point)
        {
            Turn(rig, state, animated, toTrunk, motion, local, model);
            Vector3 eyes = model.Positions[rig.Head] + Rotation.Rotate(model.Rotations[rig.Head], rig.EyePoint);
            goal = LookAngles.Of(Rotation.Rotate(toTrunk, target.Point - eyes), state.Yaw);
            attention = 1f;
        }
        else if (target.Kind == GazeTargetKind.Direction)
        {
            goal = target.Angles;
            attention = 1f;
        }

        if (Math.Abs(goal.Yaw) > settings.LoseBeyond)
        {
            attention = 0f;
        }

        LookAngles bounded = Bounded(goal, state.Yaw, settings);
        double decay = PortableMath.Exp(-(double)settings.Rate * seconds);
        CriticallyDampedSpring.Advance(ref state.Yaw, ref state.YawVelocity, bounded.Yaw, settings.Rate, seconds, decay);
        CriticallyDampedSpring.Advance(ref state.Pitch, ref state.PitchVelocity, bounded.Pitch, settings.Rate, seconds, decay);
        CriticallyDampedSpring.Advance(ref state.Attention, ref state.AttentionVelocity, attention, settings.FadeRate, seconds);
        if (attention == 0f && state.Attention < MinAttention && Math.Abs(state.AttentionVelocity) <= settings.FadeRate * MinAttention)
        {
            state.Attention = 0f;
            state.AttentionVelocity = 0f;
        }

        Turn(rig, state, animated, toTrunk, motion, local, model);
        Subtree.LocalToModel(rig.Skeleton, joints[0], local, model);
        return goal;
    }

    /// <summary>How far a pose holds the head up, seen from the trunk, radians.</summary>
    internal static float PitchOf(GazeRig rig, in Pose model) => FastTrigonometry.OfSine(Ahead(rig, ToTrunk(rig, model), model).Y);

    private static Quaternion ToTrunk(GazeRig rig, in Pose model) => Rotation.Inverse(Rotation.Multiply(model.Rotations[rig.Base], rig.BaseToModel));

    /// <summary>Where the head points, seen from the trunk.</summary>
    private static Vector3 Ahead(GazeRig rig, Quaternion toTrunk, in Pose model) =>
        Rotation.Rotate(toTrunk, Rotation.Rotate(Rotation.Multiply(model.Rotations[rig.Head], rig.HeadToModel), Vector3.UnitZ));

    /// <summary>Brings the angles of a target within reach, on the side where the head is when it is about straight behind.</summary>
    internal static LookAngles Bounded(LookAngles goal, float yawNow, in GazeSettings settings)
    {
        float yaw = goal.Yaw;
        bool behind = Math.Abs(yaw) > (float)PortableMath.Pi - settings.BackMargin;
        if (behind && yaw * yawNow < 0f)
        {
            yaw = -yaw;
        }

        return new LookAngles(Scalar.Clamp(yaw, -settings.MaxYaw, settings.MaxYaw), Scalar.Clamp(goal.Pitch, -settings.MaxDown, settings.MaxUp));
    }

    /// <summary>Poses the chain from its motion and the state.</summary>
    private static void Turn(GazeRig rig, in GazeState state, LookAngles animated, Quaternion toTrunk, ReadOnlySpan<Quaternion> motion, in Pose local, in Pose model)
    {
        ReadOnlySpan<int> joints = rig.Joints;
        Skeleton skeleton = rig.Skeleton;
        Quaternion inTrunk = Rotation.Multiply(new LookAngles(state.Yaw, state.Pitch).Turn(), Rotation.Inverse(animated.Turn()));
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(toTrunk), Rotation.Multiply(inTrunk, toTrunk));
        var fractions = new RotationFractions(turn);
        ReadOnlySpan<Joint> bones = skeleton.AllJoints;
        Quaternion carried = model.Rotations[rig.Base];
        for (int i = 0; i < joints.Length; i++)
        {
            int joint = joints[i];
            carried = Rotation.Multiply(carried, motion[i]);
            Quaternion wanted = Rotation.Multiply(fractions.At(rig.Taken[i] * state.Attention), carried);
            Quaternion turned = UnitRotation.Renormalize(Rotation.Multiply(JointRelations.ParentInverse(skeleton, joint, model), wanted));

            // A motion that is itself beyond the limits is not pulled back by looking at nothing.
            local.Rotations[joint] = state.Attention == 0f ? motion[i] : SwingTwistLimit.ClampLocal(turned, bones[joint]);
            Subtree.Place(skeleton.Parents[joint], joint, local, model);
        }
    }
}
