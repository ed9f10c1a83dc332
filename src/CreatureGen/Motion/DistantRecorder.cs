using System.Numerics;
using CreatureGen.Motion.Distance;
using CreatureGen.Motion.Grounds;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>Records what is seen of a walker from afar: one cycle of each of its gaits at its comfortable speed on level ground.</summary>
internal static class DistantRecorder
{
    /// <summary>Seconds until a stand and a gait have come to rest and to repeat themselves.</summary>
    private const float StandSeconds = 1f;
    private const float GaitSeconds = 3f;

    private const float Step = 1f / 60f;

    /// <summary>Works it out; null for what does not walk, or flies too.</summary>
    public static DistantBody? Of(MotionProfile profile)
    {
        if (profile.Legs == null || profile.Gaits == null || profile.Flight != null)
        {
            return null;
        }

        CreatureAnimator standing = Begin(profile, null);
        Go(standing, default, StandSeconds);
        LocalPose stand = Shown(standing);
        int count = profile.Gaits.Steps.Count;
        var gaits = new Gait[count];
        var cycles = new PoseCycle[count];
        for (int i = 0; i < count; i++)
        {
            gaits[i] = profile.Gaits.Steps[i].Gait;
            cycles[i] = Record(profile, stand, gaits[i], profile.Gaits.Speeds[i].Comfortable);
        }

        return new DistantBody(gaits, cycles, profile.Legs.Body, profile.Legs.Rows > 1 ? 1f : 0f);
    }

    private static PoseCycle Record(MotionProfile profile, LocalPose stand, Gait gait, float speed)
    {
        CreatureAnimator animator = Begin(profile, gait);
        var asked = new MotionInput(speed);
        Go(animator, asked, GaitSeconds);

        // From the beginning of a cycle on.
        animator.Update((1f - animator.Phase) / animator.Frequency, asked, FlatGround.Level);
        float step = 1f / (PoseCycle.Frames * animator.Frequency);
        var frames = new LocalPose[PoseCycle.Frames + 1];
        for (int frame = 0; frame < frames.Length; frame++)
        {
            frames[frame] = Shown(animator);
            animator.Update(step, asked, FlatGround.Level);
        }

        return new PoseCycle(stand, frames, profile.Subject.StandingHeight, animator.Speed / animator.Frequency);
    }

    /// <summary>An animator whose creature does nothing by itself.</summary>
    private static CreatureAnimator Begin(MotionProfile profile, Gait? gait)
    {
        var animator = new CreatureAnimator(profile);
        MotionSettings settings = animator.Settings;
        settings.Idle = 0f;
        settings.Walking = settings.Walking with { Gait = gait };
        animator.Settings = settings;
        animator.Teleport(animator.Root, FlatGround.Level);
        return animator;
    }

    private static void Go(CreatureAnimator animator, in MotionInput asked, float seconds)
    {
        for (float time = 0f; time < seconds; time += Step)
        {
            animator.Update(Step, asked, FlatGround.Level);
        }
    }

    private static LocalPose Shown(CreatureAnimator animator)
    {
        var pose = new LocalPose(animator.Profile.Subject.Skeleton);
        pose.Take(animator.LocalPose);
        return pose;
    }
}
