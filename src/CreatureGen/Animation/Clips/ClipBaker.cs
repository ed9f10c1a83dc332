using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Animation.Grounds;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Clips;

/// <summary>Turns the motion of an animator into clips: one exact, closed cycle of each thing that a creature does, in place, on level ground.</summary>
/// <remarks>
/// The animator runs until its motion repeats; then one cycle is taken in a whole number of frames, and played at <see cref="Clip.Rate"/> it lasts up to half a frame more or less than the live
/// one. What is left between the last and the first frame is spread evenly over the cycle, so that the loop closes to the bit.
/// </remarks>
public static class ClipBaker
{
    private const float SettleSeconds = 5f;
    private const float IdleSeconds = 4f;
    private const float MeasureStep = 1f / 480f;
    private const float LongestCycle = 6f;
    private const int FewestFrames = 8;

    /// <summary>Bakes every clip of a creature.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static IReadOnlyList<Clip> Bake(Creature creature)
    {
        var profile = new MotionProfile(creature ?? throw new ArgumentNullException(nameof(creature)));
        var clips = new List<Clip>();
        foreach (ClipPlan plan in ClipPlan.Of(profile))
        {
            clips.Add(Bake(profile, plan));
        }

        return clips;
    }

    private static Clip Bake(MotionProfile profile, ClipPlan plan)
    {
        var animator = new CreatureAnimator(profile);
        LocomotionSettings settings = animator.Settings;
        settings.Gait = plan.Gait;
        animator.Settings = settings;
        animator.Teleport(animator.Root, FlatGround.Level);
        Settle(animator, plan, SettleSeconds);
        float cycle = plan.IsCyclic ? CycleOf(animator, plan) : IdleSeconds;
        int frames = Math.Max(FewestFrames, (int)Math.Round(cycle * Clip.Rate));
        float step = cycle / frames;
        for (int k = 0; k < 2 * frames; k++)
        {
            Advance(animator, plan, step);
        }

        return Record(animator, plan, frames, step);
    }

    private static Clip Record(CreatureAnimator animator, ClipPlan plan, int frames, float step)
    {
        Skeleton skeleton = animator.Profile.Creature.Skeleton;
        int joints = skeleton.Count;
        var rotations = new Quaternion[(frames + 1) * joints];
        var positions = new Vector3[(frames + 1) * joints];
        double speed = 0;
        for (int frame = 0; frame <= frames; frame++)
        {
            animator.LocalPose.Rotations.CopyTo(rotations.AsSpan(frame * joints, joints));
            animator.LocalPose.Positions.CopyTo(positions.AsSpan(frame * joints, joints));
            if (frame < frames)
            {
                Advance(animator, plan, step);
                speed += animator.Speed / frames;
            }
        }

        for (int joint = 0; joint < joints; joint++)
        {
            Close(rotations, positions, joint, joints, frames);
        }

        return new Clip(plan.Name, ClipEnd.Loops, (float)(speed * step * Clip.Rate), joints, rotations, positions);
    }

    /// <summary>Spreads the difference of the last and the first frame of a joint over all frames.</summary>
    private static void Close(Quaternion[] rotations, Vector3[] positions, int joint, int joints, int frames)
    {
        Quaternion first = rotations[joint];
        Quaternion missing = Rotation.Multiply(first, Rotation.Inverse(rotations[(frames * joints) + joint]));
        Vector3 gap = positions[joint] - positions[(frames * joints) + joint];
        for (int frame = 1; frame < frames; frame++)
        {
            int at = (frame * joints) + joint;
            float share = frame / (float)frames;
            rotations[at] = Rotation.Normalize(Rotation.Multiply(Rotation.Slerp(Quaternion.Identity, missing, share), rotations[at]));
            positions[at] += gap * share;
        }

        rotations[(frames * joints) + joint] = first;
        positions[(frames * joints) + joint] = positions[joint];
    }

    /// <summary>Seconds from one beginning of the cycle to the next.</summary>
    private static float CycleOf(CreatureAnimator animator, ClipPlan plan)
    {
        float began = -1f;
        float before = animator.Phase;
        for (float time = MeasureStep; time < 2f * LongestCycle; time += MeasureStep)
        {
            Advance(animator, plan, MeasureStep);
            float phase = animator.Phase;
            if (phase < before - 0.5f)
            {
                // Where between the two updates the cycle began.
                float beyond = phase / (phase + 1f - before);
                float at = time - (MeasureStep * beyond);
                if (began >= 0f)
                {
                    return at - began;
                }

                began = at;
            }

            before = phase;
        }

        return IdleSeconds;
    }

    private static void Settle(CreatureAnimator animator, ClipPlan plan, float seconds)
    {
        for (float time = 0f; time < seconds; time += 1f / 60f)
        {
            Advance(animator, plan, 1f / 60f);
        }
    }

    private static void Advance(CreatureAnimator animator, ClipPlan plan, float step)
    {
        // It looks straight ahead: glances would not repeat.
        animator.LookAt = animator.Root.Position + Rotation.Rotate(animator.Root.Rotation, new Vector3(0f, animator.Profile.Creature.StandingHeight, 100f * animator.Profile.Creature.StandingHeight));
        animator.Update(step, plan.Input, FlatGround.Level);
    }
}
