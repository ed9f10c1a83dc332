using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion.Clips;

/// <summary>An act, recorded as a clip that happens once.</summary>
internal static class RecordedAct
{
    /// <summary>Seconds that it goes on after the act, so that what swings comes to rest.</summary>
    private const float Afterwards = 0.4f;

    private const float SettleSeconds = 0.5f;

    public static Clip Bake(MotionProfile profile, ActAbility ability) => ClipRate.Record(profile.Subject.Skeleton, rate => Record(profile, ability, rate));

    private static Clip Record(MotionProfile profile, ActAbility ability, int rate)
    {
        float step = 1f / rate;
        var animator = new CreatureAnimator(profile);
        MotionSettings settings = animator.Settings;

        // Nothing but the act: a clip does not glance about.
        settings.Idle = 0f;
        animator.Settings = settings;
        animator.Teleport(animator.Root, FlatGround.Level);
        for (int i = 0; i < (int)(SettleSeconds / step); i++)
        {
            animator.Update(step, default, FlatGround.Level);
        }

        animator.Perform(ability);
        int joints = profile.Subject.Skeleton.Count;
        int frames = (int)Math.Ceiling((ability.Seconds + Afterwards) / step);
        int leaves = ability.SecondsToLast > 0f ? (int)(ability.SecondsToLast / step) : -1;
        var rotations = new Quaternion[(frames + 1) * joints];
        var positions = new Vector3[(frames + 1) * joints];
        var events = new List<ClipEvent>();
        for (int frame = 0; frame <= frames; frame++)
        {
            animator.LocalPose.Rotations.CopyTo(rotations.AsSpan(frame * joints, joints));
            animator.LocalPose.Positions.CopyTo(positions.AsSpan(frame * joints, joints));
            if (frame == leaves)
            {
                animator.GoOn();
            }

            animator.Update(step, default, FlatGround.Level);
            foreach (ActEvent one in animator.ActEvents)
            {
                float at = ((frame + 1) * step) - one.SecondsAgo;
                if (frame < frames && ClipEvents.NameOf(one.Act, one.Mark) is { } name)
                {
                    events.Add(new ClipEvent(Scalar.Clamp(at, 0f, frames / (float)rate), name, one.Joint < 0 ? string.Empty : profile.Subject.Skeleton.Joints[one.Joint].Name, 1f));
                }
            }
        }

        return new Clip(ability.Act.Name, ClipEnd.Stays, rate, 0f, joints, rotations, positions).WithEvents(events);
    }
}
