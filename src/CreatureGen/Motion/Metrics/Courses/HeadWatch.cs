using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Watches a head as a whole: the joints of a neck share its turns, so that none of them is fast where the head jumps.</summary>
internal sealed class HeadWatch
{
    private readonly int head;
    private Quaternion before;
    private bool begun;

    /// <summary>Watches the first head of a skeleton.</summary>
    public HeadWatch(Skeleton skeleton) => head = skeleton.FirstOf(JointRole.Head);

    /// <summary>Greatest rate at which it turned, as seen from the root, radians per second; null without a head.</summary>
    public float? Speed { get; private set; }

    /// <summary>Watches a pose.</summary>
    /// <param name="model">In model space.</param>
    /// <param name="dt">Seconds since the last, above 0.</param>
    public void Record(in Pose model, float dt)
    {
        if (head < 0)
        {
            return;
        }

        Quaternion now = model.Rotations[head];
        double turned = begun ? Rotation.AngleBetween(before, now) : 0;
        Speed = Math.Max(Speed ?? 0f, (float)(turned / dt));
        before = now;
        begun = true;
    }
}
