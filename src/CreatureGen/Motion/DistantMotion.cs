using CreatureGen.Motion.Distance;
using CreatureGen.Motion.Falling;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>One creature on the scene as it is seen from afar: which cycle it shows, and what is left of the pose before a change of detail or gait.</summary>
internal sealed class DistantMotion
{
    /// <summary>Seconds in which the difference of the pose dies away where detail or gait changes.</summary>
    private const float FadeSeconds = 0.25f;

    private readonly PoseFade fade;
    private MotionDetail detail;
    private int shown;

    public DistantMotion(MotionProfile profile)
    {
        Body = profile.Distant.Value;
        fade = new PoseFade(profile.Subject.Skeleton);
    }

    /// <summary>Its cycles; null for what only leaves out head and springs.</summary>
    public DistantBody? Body { get; }

    /// <summary>Whether it only travels at present, its feet where nobody sees them.</summary>
    public bool MovesRoot { get; private set; }

    /// <summary>Takes up the detail that is asked.</summary>
    /// <param name="asked">The detail.</param>
    /// <param name="local">The pose shown last.</param>
    public void Turn(MotionDetail asked, in Pose local)
    {
        if (detail != asked)
        {
            detail = asked;
            fade.Keep(local);
        }
    }

    /// <summary>Begins to travel.</summary>
    /// <param name="legs">What goes.</param>
    /// <param name="local">The pose shown last.</param>
    public void Begin(WalkingMode legs, in Pose local)
    {
        MovesRoot = true;
        legs.BeginDistant();
        fade.Keep(local);
    }

    /// <summary>Has its feet on the ground again.</summary>
    /// <param name="local">The pose shown last.</param>
    public void End(in Pose local)
    {
        MovesRoot = false;
        fade.Keep(local);
    }

    /// <summary>Forgets what it was seen as: it has been put somewhere else.</summary>
    public void Reset() => MovesRoot = false;

    /// <summary>Writes the pose of what travels.</summary>
    /// <param name="legs">What goes.</param>
    /// <param name="local">The pose shown last; receives the next, in the parents' space.</param>
    public void Pose(WalkingMode legs, in Pose local)
    {
        int cycle = Body!.CycleOf(legs.Gait, legs.UsualGait);
        if (cycle != shown)
        {
            shown = cycle;
            fade.Keep(local);
        }

        Body.Pose(cycle, legs.Phase, legs.StrideGone, legs.Underfoot, local);
    }

    /// <summary>Lays on a pose what is left of the one before a change.</summary>
    public void Fade(float dt, in Pose local) => fade.Apply(dt, FadeSeconds, local);
}
