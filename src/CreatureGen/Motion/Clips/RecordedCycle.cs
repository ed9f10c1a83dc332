using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Clips;

/// <summary>Poses of a time after which motion begins anew, with where the creature and its feet were. What is left between the last pose and the first is spread evenly, so that the poses close to the bit; what happens once is taken as it is.</summary>
internal sealed class RecordedCycle
{
    private readonly Skeleton skeleton;
    private readonly RootPlace[] places;
    private readonly FootReport[] feet;
    private readonly int footCount;
    private readonly bool closes;
    private readonly List<(float Time, string Name, MotionEvent Event)> happened = new();

    /// <summary>Records from now on.</summary>
    /// <param name="motion">What has settled.</param>
    /// <param name="frames">Number of updates.</param>
    /// <param name="step">Seconds of each.</param>
    public RecordedCycle(SteadyMotion motion, int frames, float step)
    {
        CreatureAnimator animator = motion.Animator;
        Frames = frames;
        closes = motion.Closes;
        skeleton = animator.Profile.Subject.Skeleton;
        Joints = skeleton.Count;
        Step = step;
        Rotations = new Quaternion[(frames + 1) * Joints];
        Positions = new Vector3[(frames + 1) * Joints];
        places = new RootPlace[frames + 1];
        footCount = animator.StandsOnFeet || !motion.Closes ? animator.FootCount : 0;
        feet = new FootReport[(frames + 1) * footCount];
        double speed = 0;
        for (int frame = 0; frame <= frames; frame++)
        {
            animator.LocalPose.Rotations.CopyTo(Rotations.AsSpan(frame * Joints, Joints));
            animator.LocalPose.Positions.CopyTo(Positions.AsSpan(frame * Joints, Joints));
            places[frame] = animator.Root;
            for (int foot = 0; foot < footCount; foot++)
            {
                feet[(frame * footCount) + foot] = animator.Foot(foot);
            }

            if (frame < frames)
            {
                motion.Live((frame + 1) * step, frames * step);
                motion.Advance(step);
                foreach (MotionEvent one in animator.Events)
                {
                    if (ClipEvents.NameOf(one.Kind) is { } name)
                    {
                        happened.Add((((frame + 1) * step) - one.SecondsAgo, name, one));
                    }
                }

                speed += animator.Speed / frames;
            }
        }

        MeanSpeed = speed;
        for (int joint = 0; joint < Joints && motion.Closes; joint++)
        {
            Close(joint);
        }
    }

    /// <summary>Number of frames but the last, which is the first again.</summary>
    public int Frames { get; }

    /// <summary>Number of joints.</summary>
    public int Joints { get; }

    /// <summary>Number of feet that the creature goes on; 0 in the air and in water.</summary>
    public int Feet => footCount;

    /// <summary>Seconds from frame to frame.</summary>
    public float Step { get; }

    /// <summary>Metres per second.</summary>
    public double MeanSpeed { get; }

    /// <summary>One for each joint of each frame, in the parents' space.</summary>
    public Quaternion[] Rotations { get; }

    /// <summary>One for each joint of each frame, in the parents' space.</summary>
    public Vector3[] Positions { get; }

    /// <summary>The farthest that any joint turns from one frame to the next, radians. A blink is a matter of a frame or two and does not count.</summary>
    public float FarthestTurn()
    {
        float min = 1f;
        for (int frame = 1; frame <= Frames; frame++)
        {
            min = Math.Min(min, ClipRate.MinDot(skeleton, Rotations.AsSpan((frame - 1) * Joints, Joints), Rotations.AsSpan(frame * Joints, Joints)));
        }

        return 2f * (float)PortableMath.Acos(min);
    }

    /// <summary>Where the root was.</summary>
    public RootPlace PlaceAt(int frame) => places[frame];

    /// <summary>The way over the ground, seen from where it began; without headings where the poses hold them.</summary>
    public IReadOnlyList<ClipPlace> Path()
    {
        var path = new ClipPlace[Frames + 1];
        Quaternion back = Rotation.Inverse(places[0].Rotation);
        float heading = 0f;
        for (int frame = 0; frame <= Frames; frame++)
        {
            Vector3 way = Rotation.Rotate(back, places[frame].Position - places[0].Position);
            if (frame > 0 && closes)
            {
                // From frame to frame, so that a turn may be more than a round.
                Quaternion step = Rotation.Multiply(Rotation.Inverse(places[frame - 1].Rotation), places[frame].Rotation);
                heading += (float)(2 * PortableMath.Atan2(step.W < 0f ? -step.Y : step.Y, Math.Abs(step.W)));
            }

            path[frame] = new ClipPlace(new Vector3(way.X, closes ? way.Y : 0f, way.Z), heading);
        }

        return path;
    }

    /// <summary>What happened, as events of a clip of so many frames per second. What happened just before the first frame of a cycle happens at its end.</summary>
    public IReadOnlyList<ClipEvent> EventsAt(int rate)
    {
        float duration = Frames / (float)rate;
        var events = new List<ClipEvent>();
        foreach ((float time, string name, MotionEvent one) in happened)
        {
            float at = time / (Step * rate);
            at = at < 0f ? at + duration : at;
            events.Add(new ClipEvent(Scalar.Clamp(at, 0f, duration), name, skeleton.Joints[one.Joint].Name, Math.Max(one.Strength, 0f)));
        }

        return events;
    }

    /// <summary>How a foot was.</summary>
    public FootReport FootAt(int frame, int foot) => feet[(frame * footCount) + foot];

    /// <summary>Spreads the difference of the last and the first frame of a joint over all frames.</summary>
    private void Close(int joint)
    {
        int last = (Frames * Joints) + joint;
        Quaternion first = Rotations[joint];
        Quaternion missing = Rotation.Multiply(first, Rotation.Inverse(Rotations[last]));
        Vector3 gap = Positions[joint] - Positions[last];
        for (int frame = 1; frame < Frames; frame++)
        {
            int at = (frame * Joints) + joint;
            float fraction = frame / (float)Frames;
            Rotations[at] = Rotation.Normalize(Rotation.Multiply(Rotation.Slerp(Quaternion.Identity, missing, fraction), Rotations[at]));
            Positions[at] += gap * fraction;
        }

        Rotations[last] = first;
        Positions[last] = Positions[joint];
    }
}
