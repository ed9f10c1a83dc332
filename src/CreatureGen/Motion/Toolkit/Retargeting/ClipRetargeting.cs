using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Clips;
using CreatureGen.Motion.Toolkit.Retargeting;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Plays clips of one skeleton on another.</summary>
/// <remarks>
/// Each joint turns from its rest as the joint that it follows does from its own, seen in model space. The body goes as far as the lengths of the legs make it, and so do the feet: each leg is brought to where its foot then is
/// by <see cref="CcdIk"/>, within the limits of its joints, so that feet that stand, stand. Where legs do not reach so far, as upright ones where a sprawler's feet go, the body is carried a little lower, and if that is not enough the clip is made in a smaller scale: shorter steps, less speed. Shoulder blades slide as they do. Joints that follow none stay as they are at rest. Based on: M. Gleicher, "Retargetting motion to new characters" (1998).
/// </remarks>
public static class ClipRetargeting
{
    /// <summary>How far a foot may stay from where it goes, parts of its leg's length.</summary>
    private const float MaxMissed = 0.05f;

    /// <summary>By how much lower the body is carried at a time if it stays farther, and at most: parts of the longest leg.</summary>
    private const float Lower = 0.02f;
    private const float Lowest = 0.08f;

    /// <summary>By how much less far all goes at a time if that is not enough, and to what part of the map's scale at most.</summary>
    private const float Smaller = 0.9f;
    private const float Smallest = 0.3f;

    /// <summary>Makes a clip of the second skeleton of a map.</summary>
    /// <param name="clip">Of the first.</param>
    /// <param name="map">Which joints follow which.</param>
    /// <param name="name">Of the new clip: ASCII letters, digits and underscores.</param>
    /// <param name="rate">Frames per second, 1 at least; the new clip lasts up to half a frame more or less.</param>
    /// <returns>In place if the first is; its speed is that of the first, in the scale of the map.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The clip is of another number of joints than the first skeleton, or the name or the rate is wrong.</exception>
    public static Clip Apply(IClip clip, RetargetMap map, string name, int rate = Clip.UsualRate)
    {
        _ = clip ?? throw new ArgumentNullException(nameof(clip));
        _ = map ?? throw new ArgumentNullException(nameof(map));
        if (clip.Joints != map.From.Count || rate < 1)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} of {clip.Joints} joints at {rate} frames per second; expected {map.From.Count} joints and 1 frame at least"), nameof(clip));
        }

        int frames = Math.Max(2, (int)Math.Round(clip.Duration * rate) + 1);
        int count = map.To.Count;
        var rotations = new Quaternion[frames * count];
        var positions = new Vector3[frames * count];
        float scale = map.Scale;
        float drop = 0f;
        while (Fill(clip, map, scale, drop * LegOf(map), rotations, positions) > MaxMissed && scale > Smallest * map.Scale)
        {
            (drop, scale) = drop < Lowest ? (drop + Lower, scale) : (drop, scale * Smaller);
        }

        float duration = (frames - 1) / (float)rate;
        var made = new Clip(name, clip.End, rate, clip.Speed * scale * clip.Duration / duration, count, rotations, positions);
        return made.WithEvents(EventsOf(clip, map, duration));
    }

    private static float LegOf(RetargetMap map)
    {
        float longest = 0f;
        foreach (RetargetedLeg leg in map.Legs)
        {
            longest = Math.Max(longest, Reach(map.To, leg));
        }

        return longest;
    }

    /// <summary>From the hip to the foot of a leg at rest, metres.</summary>
    private static float Reach(Skeleton to, in RetargetedLeg leg) => Vec.Distance(to.ModelPositions[leg.Chain[0]], to.ModelPositions[leg.Chain[leg.Chain.Length - 1]]);

    /// <summary>Fills in all frames at a scale, the body so much lower, and gives how far the worst foot stays from where it goes, parts of its leg's length.</summary>
    private static float Fill(IClip clip, RetargetMap map, float scale, float drop, Quaternion[] rotations, Vector3[] positions)
    {
        int count = map.To.Count;
        int frames = rotations.Length / count;
        var shown = new ModelPose(map.From);
        float missed = 0f;
        for (int frame = 0; frame < frames; frame++)
        {
            if (frame == frames - 1 && clip.End == ClipEnd.Loops)
            {
                rotations.AsSpan(0, count).CopyTo(rotations.AsSpan(frame * count));
                positions.AsSpan(0, count).CopyTo(positions.AsSpan(frame * count));
                break;
            }

            shown.Sample(clip, ClipError.PartOf(clip.Duration, frame, frames));
            missed = Math.Max(missed, Turn(map, scale, drop, shown.Pose, new Pose(rotations.AsSpan(frame * count, count), positions.AsSpan(frame * count, count))));
        }

        return missed;
    }

    /// <summary>One pose: the first skeleton's in model space becomes the second's in the parents' space. Gives how far the worst foot stays from where it goes, parts of its leg's length.</summary>
    private static float Turn(RetargetMap map, float scale, float drop, in Pose shown, in Pose local)
    {
        Skeleton to = map.To;
        local.SetToRest(to);
        var model = new Pose(to.ModelRotations.ToArray(), to.ModelPositions.ToArray());
        int next = 0;
        for (int joint = 0; joint < to.Count; joint++)
        {
            int parent = to.Parents[joint];
            Quaternion above = parent < 0 ? Quaternion.Identity : model.Rotations[parent];
            Vector3 origin = parent < 0 ? Vector3.Zero : model.Positions[parent];
            if (joint == map.ToCarrier)
            {
                Vector3 moved = shown.Positions[map.FromCarrier] - map.From.ModelPositions[map.FromCarrier];
                Vector3 place = to.ModelPositions[joint] + (scale * moved) - new Vector3(0f, drop, 0f);
                local.Positions[joint] = Rotation.Rotate(Rotation.Inverse(above), place - origin);
            }

            if (next < map.Joints.Count && map.Joints[next].Joint == joint)
            {
                RetargetedJoint follows = map.Joints[next];
                Quaternion turn = Rotation.Slerp(FromRest(map.From, shown, follows.Before), FromRest(map.From, shown, follows.After), follows.Part);
                Quaternion wanted = Rotation.Multiply(turn, Rotation.Multiply(follows.Align, to.ModelRotations[joint]));
                local.Rotations[joint] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(above), wanted));
                local.Rotations[joint] = SwingTwistLimit.ClampLocal(local.Rotations[joint], to.Joints[joint]);
                if (follows.Slide > 0f)
                {
                    local.Positions[joint] += Rotation.Rotate(Rotation.Inverse(above), follows.Slide * Slid(map.From, shown, follows.Before));
                }

                next++;
            }

            model.Rotations[joint] = Rotation.Multiply(above, local.Rotations[joint]);
            model.Positions[joint] = origin + Rotation.Rotate(above, local.Positions[joint]);
        }

        float missed = 0f;
        foreach (RetargetedLeg leg in map.Legs)
        {
            int foot = leg.Chain[leg.Chain.Length - 1];
            Vector3 goal = to.ModelPositions[foot] + (scale * (shown.Positions[leg.Foot] - map.From.ModelPositions[leg.Foot]));
            IkResult result = CcdIk.Apply(to, leg.Chain, goal, CcdSettings.Default, local, model);
            missed = Math.Max(missed, result.Residual / Reach(to, leg));
        }

        return missed;
    }

    /// <summary>How far a joint has slid from its rest on its parent, model space.</summary>
    private static Vector3 Slid(Skeleton skeleton, in Pose model, int joint)
    {
        int parent = skeleton.Parents[joint];
        return model.Positions[joint] - (model.Positions[parent] + Rotation.Rotate(model.Rotations[parent], skeleton.LocalPositions[joint]));
    }

    /// <summary>How far a joint has turned from its rest, model space.</summary>
    private static Quaternion FromRest(Skeleton skeleton, in Pose model, int joint) =>
        Rotation.Normalize(Rotation.Multiply(model.Rotations[joint], Rotation.Inverse(skeleton.ModelRotations[joint])));

    private static List<ClipEvent> EventsOf(IClip clip, RetargetMap map, float duration)
    {
        var events = new List<ClipEvent>();
        foreach (ClipEvent one in clip.Events)
        {
            int joint = map.From.IndexOf(one.Joint);
            int other = joint < 0 ? -1 : map.JointFor(joint);
            events.Add(new ClipEvent(Math.Min(one.Time / clip.EventSpan * duration, duration), one.Name, other < 0 ? string.Empty : map.To.Joints[other].Name, one.Strength));
        }

        return events;
    }
}
