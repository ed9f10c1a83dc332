using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Clips;

/// <summary>Records what happens once, stage by stage, as a clip in place that stays at its end: the joint <c>Body</c> carries heading and height, the path is kept beside it.</summary>
internal sealed class RecordedPassage
{
    /// <summary>Updates in a second at the least.</summary>
    private const int UsualUpdates = 2 * Clip.UsualRate;

    private readonly int rate;
    private readonly int updatesPerFrame;
    private readonly float step;

    private readonly CreatureAnimator animator;
    private readonly RootPlace start;
    private readonly int body;
    private readonly List<Quaternion> rotations = new();
    private readonly List<Vector3> positions = new();
    private readonly List<ClipPlace> path = new();
    private readonly List<ClipEvent> events = new();
    private float way;
    private bool falls;

    /// <summary>Begins with the pose that is shown.</summary>
    /// <param name="animator">Of whom.</param>
    /// <param name="rate">Frames a second, the usual or a power of two of it.</param>
    public RecordedPassage(CreatureAnimator animator, int rate)
    {
        this.animator = animator;
        this.rate = rate;
        updatesPerFrame = Math.Max(UsualUpdates / rate, 1);
        step = 1f / (rate * updatesPerFrame);
        start = animator.Root;
        body = animator.Profile.Subject.Skeleton.FirstOf(JointRole.Body);
        Keep();
    }

    /// <summary>Seconds recorded so far.</summary>
    public float Seconds => (path.Count - 1) / (float)rate;

    /// <summary>Leaves out the height from here on: the game moves it.</summary>
    public RecordedPassage InPlace()
    {
        falls = true;
        return this;
    }

    /// <summary>Records a stage.</summary>
    /// <param name="seconds">How long at most.</param>
    /// <param name="input">What is asked.</param>
    /// <param name="ground">What it goes on.</param>
    /// <param name="isOver">What ends it sooner.</param>
    public RecordedPassage Stage(float seconds, in MotionInput input, IGround ground, Func<CreatureAnimator, bool>? isOver = null)
    {
        for (int frame = 0; frame < (int)Math.Ceiling(seconds * rate) && !(isOver?.Invoke(animator) ?? false); frame++)
        {
            for (int i = 0; i < updatesPerFrame; i++)
            {
                Update(animator, step, input, ground);
                way += animator.Speed * step;
                foreach (MotionEvent one in animator.Events)
                {
                    if (ClipEvents.NameOf(one.Kind) is { } name)
                    {
                        float at = Seconds + ((i + 1) * step) - one.SecondsAgo;
                        events.Add(new ClipEvent(Math.Max(at, 0f), name, animator.Profile.Subject.Skeleton.Joints[one.Joint].Name, Math.Max(one.Strength, 0f)));
                    }
                }
            }

            Keep();
        }

        return this;
    }

    /// <summary>What was recorded.</summary>
    public Clip Finish(string name)
    {
        if (path.Count == 1)
        {
            Keep();
        }

        float duration = Seconds;
        var clip = new Clip(name, ClipEnd.Stays, rate, way / duration, animator.Profile.Subject.Skeleton.Count, rotations.ToArray(), positions.ToArray());
        return clip.WithEvents(events.ConvertAll(one => new ClipEvent(Math.Min(one.Time, duration), one.Name, one.Joint, one.Strength))).WithPath(path);
    }

    /// <summary>Goes on by one update, looking straight ahead: glances of its own are no part of a clip.</summary>
    public static void Update(CreatureAnimator animator, in MotionInput input, IGround ground) => Update(animator, 1f / UsualUpdates, input, ground);

    private static void Update(CreatureAnimator animator, float step, in MotionInput input, IGround ground)
    {
        float height = animator.Profile.Subject.StandingHeight;
        animator.LookAt = animator.Root.Position + Rotation.Rotate(animator.Root.Rotation, new Vector3(0f, height, 100f * height));
        animator.Update(step, input, ground);
    }

    private void Keep()
    {
        Quaternion back = Rotation.Inverse(start.Rotation);
        Vector3 moved = Rotation.Rotate(back, animator.Root.Position - start.Position);
        Quaternion heading = Rotation.Multiply(back, animator.Root.Rotation);
        Pose local = animator.LocalPose;
        for (int joint = 0; joint < local.Rotations.Length; joint++)
        {
            bool carries = joint == body;
            rotations.Add(carries ? Rotation.Normalize(Rotation.Multiply(heading, local.Rotations[joint])) : local.Rotations[joint]);
            positions.Add(carries ? Rotation.Rotate(heading, local.Positions[joint]) + new Vector3(0f, falls ? 0f : moved.Y, 0f) : local.Positions[joint]);
        }

        path.Add(new ClipPlace(new Vector3(moved.X, 0f, moved.Z), 0f));
    }
}
