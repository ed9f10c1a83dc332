using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>A head beside the first: it is carried as the first is and does in acts what the first does, a little later, but looks about and blinks by itself.</summary>
/// <remarks>
/// Its neck leans to the other side. What the first neck's joints turn in model space those of the second turn, too: both go the same way and not each other's mirror image's, so that what the one
/// reaches for the other reaches for beside it.
/// </remarks>
internal sealed class SecondHead
{
    /// <summary>How quickly neck, head and ears come after those of the first, per second.</summary>
    private const double Following = 11;

    /// <summary>The same of the jaw, which is not to come too late to a bite.</summary>
    private const double Biting = 50;

    private readonly Skeleton skeleton;
    private readonly int[] first;
    private readonly int[] second;
    private readonly Quaternion[] before;
    private readonly Quaternion[] after;
    private readonly Quaternion[] carried;
    private readonly Quaternion[] looking;
    private readonly Quaternion[] shown;
    private readonly int root;
    private readonly HeadRoom? room;
    private bool isShown;

    private SecondHead(Skeleton skeleton, int[] first, int[] second, HeadGaze gaze, HeadRoom? room)
    {
        this.room = room;
        this.skeleton = skeleton;
        this.first = first;
        this.second = second;
        Gaze = gaze;
        int count = first.Length;
        before = new Quaternion[count];
        after = new Quaternion[count];
        carried = new Quaternion[count];
        looking = new Quaternion[count];
        shown = new Quaternion[count];
        root = second[0];
        ReadOnlySpan<Quaternion> rest = skeleton.ModelRotations;
        for (int i = 0; i < count; i++)
        {
            before[i] = Rotation.Multiply(Rotation.Inverse(rest[skeleton.Parents[second[i]]]), rest[skeleton.Parents[first[i]]]);
            after[i] = Rotation.Multiply(Rotation.Inverse(rest[first[i]]), rest[second[i]]);
        }
    }

    /// <summary>Where it looks, and when it blinks.</summary>
    public HeadGaze Gaze { get; }

    /// <summary>The second head of a body; null where there is none.</summary>
    public static SecondHead? Of(MotionSubject subject)
    {
        Skeleton skeleton = subject.Skeleton;
        var first = new List<int>();
        var second = new List<int>();
        for (int j = 0; j < skeleton.Count; j++)
        {
            string name = skeleton.Joints[j].Name;
            int twin = name.EndsWith(Heads.Suffix, StringComparison.Ordinal) ? skeleton.IndexOf(name.Substring(0, name.Length - Heads.Suffix.Length)) : -1;
            if (twin >= 0 && (Heads.IsFurther(skeleton, j) || second.Contains(skeleton.Parents[j])))
            {
                first.Add(twin);
                second.Add(j);
            }
        }

        int head = second.Find(joint => skeleton.Joints[joint].Role == JointRole.Head);
        if (head <= 0)
        {
            return null;
        }

        var gaze = new HeadGaze(GazeRig.Of(skeleton, head), subject, subject.Habits.Child("second head"));
        HeadRoom? room = HeadRoom.Of(skeleton, subject.Bones, (first[0], first[second.IndexOf(head)]), (second[0], head));
        return new SecondHead(skeleton, first.ToArray(), second.ToArray(), gaze, room);
    }

    /// <summary>Takes down how the first head is carried, before it looks anywhere.</summary>
    public void NoteCarried(in Pose local) => Note(local, carried);

    /// <summary>Takes down where the first head looks, before it acts.</summary>
    public void NoteLooking(in Pose local) => Note(local, looking);

    /// <summary>Goes after the first head.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="local">The pose, the first head as it acts; the second is turned.</param>
    /// <param name="model">The same in model space, brought up to date.</param>
    public void Follow(float dt, in Pose local, in Pose model)
    {
        float slow = isShown ? 1f - (float)PortableMath.Exp(-Following * dt) : 1f;
        float quick = isShown ? 1f - (float)PortableMath.Exp(-Biting * dt) : 1f;
        for (int i = 0; i < first.Length; i++)
        {
            Joint joint = skeleton.AllJoints[second[i]];

            // What the first does beside looking: its act on top of how it is carried.
            Quaternion acted = Rotation.Multiply(Rotation.Multiply(local.Rotations[first[i]], Rotation.Inverse(looking[i])), carried[i]);
            Quaternion wanted = Rotation.Multiply(Rotation.Multiply(before[i], acted), after[i]);
            if (joint.Role is JointRole.Neck or JointRole.Head or JointRole.Jaw)
            {
                wanted = SwingTwistLimit.ClampLocal(wanted, joint);
            }

            float share = joint.Role == JointRole.Jaw ? quick : slow;
            shown[i] = Rotation.Normalize(share == 1f ? wanted : Rotation.Nlerp(shown[i], wanted, share));
            local.Rotations[second[i]] = shown[i];
        }

        isShown = true;
        Subtree.LocalToModel(skeleton, root, local, model);
    }

    /// <summary>Keeps both heads out of each other, once they look and act.</summary>
    public void KeepApart(in Pose local, in Pose model) => room?.Keep(local, model);

    /// <summary>Goes on from where something else has put it: it hangs limp, or gets up.</summary>
    public void Rest(in Pose local)
    {
        for (int i = 0; i < second.Length; i++)
        {
            shown[i] = local.Rotations[second[i]];
        }

        isShown = true;
    }

    /// <summary>Is where the first head is, at once.</summary>
    public void Reset()
    {
        isShown = false;
        Gaze.Reset();
    }

    private void Note(in Pose local, Quaternion[] into)
    {
        for (int i = 0; i < first.Length; i++)
        {
            into[i] = local.Rotations[first[i]];
        }
    }
}
