using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Metrics;

/// <summary>Watches an animator and measures its motion: joints beyond their limits, jumps of the pose, and, while it is on its feet, sliding, sinking and floating, clearance, legs that fall short, feet on the ground.</summary>
/// <remarks>For tools and tests, not for frames of a game: it skins the feet in every frame. <see cref="MotionTrial"/> runs it over the movements of a creature; by itself it measures what a game does with its own input and its own ground.</remarks>
internal sealed class MotionRecorder
{
    private const float LimitTolerance = 0.0017453f;

    private readonly CreatureAnimator animator;
    private readonly Skeleton skeleton;
    private readonly FeetRecorder? feet;
    private readonly Matrix4x4[] matrices;
    private readonly Quaternion[] before;
    private readonly List<float> changes = new();
    private int frames;
    private double seconds;
    private float limitExcess;
    private int limitViolations;
    private int worstJoint = -1;
    private float fastest;

    /// <summary>Watches an animator.</summary>
    /// <exception cref="ArgumentNullException">There is no animator.</exception>
    public MotionRecorder(CreatureAnimator animator)
    {
        this.animator = animator ?? throw new ArgumentNullException(nameof(animator));
        skeleton = animator.Profile.Subject.Skeleton;
        matrices = new Matrix4x4[skeleton.Count];
        before = new Quaternion[skeleton.Count];
        feet = animator.Profile.Legs == null ? null : new FeetRecorder(animator, animator.Profile.Legs);
    }

    /// <summary>Measures the animator's pose after an update.</summary>
    /// <param name="dt">Seconds of that update.</param>
    /// <param name="ground">The ground it went on.</param>
    public void Record(float dt, IGround ground)
    {
        MeasureJoints(dt);
        if (feet != null && animator.StandsOnFeet)
        {
            SkinMatrices.Fill(skeleton, animator.ModelPose, matrices);
            feet.Record(dt, ground, matrices);
        }
        else
        {
            feet?.LeaveGround();
        }

        frames++;
        seconds += dt;
    }

    /// <summary>What was measured so far.</summary>
    /// <exception cref="InvalidOperationException">Nothing was recorded.</exception>
    public MotionReport Report()
    {
        if (frames == 0)
        {
            throw new InvalidOperationException("nothing was recorded; expected at least one frame");
        }

        changes.Sort();
        float median = changes.Count == 0 ? 0f : changes[changes.Count / 2];
        float jump = changes.Count == 0 || median <= 0f ? 1f : changes[changes.Count - 1] / median;
        var report = new MotionReport(frames, (float)seconds, limitExcess, limitViolations, worstJoint, fastest, jump);
        return feet == null ? report : feet.AddTo(report);
    }

    private void MeasureJoints(float dt)
    {
        double change = 0;
        ReadOnlySpan<Quaternion> rotations = animator.LocalPose.Rotations;
        for (int j = 0; j < skeleton.Count; j++)
        {
            Joint joint = skeleton.Joints[j];
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), rotations[j]);
            if (joint.Role is not JointRole.Root and not JointRole.Body and not JointRole.End)
            {
                float excess = SwingTwistLimit.Excess(Rotation.Normalize(turn), joint.Limit);
                limitViolations += excess > LimitTolerance ? 1 : 0;
                if (excess > limitExcess)
                {
                    limitExcess = excess;
                    worstJoint = j;
                }
            }

            if (frames > 0 && dt > 0f)
            {
                float angle = (float)Rotation.Angle(Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(before[j]), rotations[j])));
                change += joint.Role == JointRole.Lid ? 0 : angle * angle;
                fastest = joint.Role is JointRole.Lid or JointRole.Tail or JointRole.Ear or JointRole.Antenna ? fastest : Math.Max(fastest, angle / dt);
            }

            before[j] = rotations[j];
        }

        if (frames > 0 && dt > 0f)
        {
            changes.Add((float)Math.Sqrt(change) / dt);
        }
    }
}
