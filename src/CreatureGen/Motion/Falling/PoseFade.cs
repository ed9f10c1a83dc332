using System;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A transition to a motion that is known from its first pose on: the difference to what was shown dies away on top of it, within the limits of the joints.</summary>
internal sealed class PoseFade
{
    private readonly Skeleton skeleton;
    private readonly LocalPose shown;
    private readonly LocalPose before;
    private readonly InertialOffset[] offsets;
    private bool begins;
    private float elapsed;
    private float duration;
    private float step;

    public PoseFade(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        shown = new LocalPose(skeleton);
        before = new LocalPose(skeleton);
        offsets = new InertialOffset[skeleton.Count];
    }

    /// <summary>Keeps what was shown last.</summary>
    public void Keep(in Pose local) => Keep(local, local, 0f);

    /// <summary>Keeps what was shown last and how it moved: that goes on and dies away.</summary>
    /// <param name="local">Shown last.</param>
    /// <param name="earlier">Shown before that.</param>
    /// <param name="seconds">Between them; 0 for what did not move.</param>
    public void Keep(in Pose local, in Pose earlier, float seconds)
    {
        shown.Take(local);
        before.Take(earlier);
        step = seconds;
        begins = true;
    }

    /// <summary>Forgets what was shown.</summary>
    public void Stop() => (begins, duration) = (false, 0f);

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(PoseFade other)
    {
        shown.Take(other.shown.Pose);
        before.Take(other.before.Pose);
        other.offsets.CopyTo(offsets, 0);
        (begins, elapsed, duration, step) = (other.begins, other.elapsed, other.duration, other.step);
    }

    /// <summary>Lays on a pose what is left of the difference.</summary>
    /// <param name="dt">Seconds since the last pose.</param>
    /// <param name="seconds">In which all dies away; taken up with the first pose.</param>
    /// <param name="local">The motion's.</param>
    public void Apply(float dt, float seconds, in Pose local)
    {
        if (begins)
        {
            Inertialisation.Start(shown.Pose, before.Pose, local, local, step, seconds, offsets);
            begins = false;
            elapsed = 0f;
            duration = seconds;
        }

        elapsed += dt;
        if (elapsed < duration)
        {
            Inertialisation.Apply(offsets, elapsed, local);
            SwingTwistLimit.ClampPose(skeleton, local);
        }
    }
}
