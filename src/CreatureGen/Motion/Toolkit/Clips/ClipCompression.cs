using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Clips;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Clips of fewer keys and fewer bytes, as near to the motion that they are made of as a <see cref="ClipPrecision"/> asks.</summary>
/// <remarks>
/// Each track keeps as few of its frames as will do within a tolerance of its own: the smaller, the farther what hangs on the joint reaches. The tolerance of all is found by halving: the largest at which the whole skeleton,
/// with the errors of joints on top of those of their parents, keeps to the precision in model space.
/// </remarks>
public static class ClipCompression
{
    /// <summary>Halvings of the range in which the tolerance is looked for.</summary>
    private const int Halvings = 6;

    /// <summary>The range, in parts of the error allowed.</summary>
    private const double SmallestTolerance = 1.0 / 64;
    private const double LargestTolerance = 4;

    /// <summary>Cases that may be worse than the error allowed, of a hundred.</summary>
    private const int WorseOfHundred = 1;

    /// <summary>Leaves out the frames that others make up for. A loop still closes to the bit.</summary>
    /// <param name="clip">What is reduced.</param>
    /// <param name="skeleton">Of the clip.</param>
    /// <param name="precision">How near.</param>
    /// <exception cref="ArgumentNullException">There is no clip or no skeleton.</exception>
    /// <exception cref="ArgumentException">The clip is of another number of joints.</exception>
    public static KeyedClip Reduce(Clip clip, Skeleton skeleton, in ClipPrecision precision) => Reduce(clip, clip?.Rate ?? 1, skeleton, precision);

    /// <summary>The same of any clip.</summary>
    /// <param name="clip">What is reduced.</param>
    /// <param name="rate">Frames per second from which keys are chosen, 1 at least.</param>
    /// <param name="skeleton">Of the clip.</param>
    /// <param name="precision">How near it is to those frames.</param>
    /// <exception cref="ArgumentNullException">There is no clip or no skeleton.</exception>
    /// <exception cref="ArgumentException">The clip is of another number of joints, or the rate is below 1.</exception>
    public static KeyedClip Reduce(IClip clip, int rate, Skeleton skeleton, in ClipPrecision precision)
    {
        var search = new Search(Frames(clip, rate, skeleton), skeleton, precision);
        return search.Largest(search.Keyed);
    }

    /// <summary>Leaves out the frames that others make up for, and keeps the others in 48 bits each. A loop still closes to the bit.</summary>
    /// <param name="clip">What is compressed.</param>
    /// <param name="skeleton">Of the clip.</param>
    /// <param name="precision">How near. It can be missed by creatures many metres long, of whose bones 48 bits move the ends by more.</param>
    /// <exception cref="ArgumentNullException">There is no clip or no skeleton.</exception>
    /// <exception cref="ArgumentException">The clip is of another number of joints, or it has more than 65,535 frames.</exception>
    public static CompressedClip Compress(Clip clip, Skeleton skeleton, in ClipPrecision precision) => Compress(clip, clip?.Rate ?? 1, skeleton, precision);

    /// <summary>The same of any clip.</summary>
    /// <param name="clip">What is compressed.</param>
    /// <param name="rate">Frames per second from which keys are chosen, 1 at least.</param>
    /// <param name="skeleton">Of the clip.</param>
    /// <param name="precision">How near it is to those frames.</param>
    /// <exception cref="ArgumentNullException">There is no clip or no skeleton.</exception>
    /// <exception cref="ArgumentException">The clip is of another number of joints, the rate is below 1, or there are more than 65,535 frames.</exception>
    public static CompressedClip Compress(IClip clip, int rate, Skeleton skeleton, in ClipPrecision precision)
    {
        ClipFrames frames = Frames(clip, rate, skeleton);
        if (frames.Count > ushort.MaxValue)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} has {frames.Count} frames; expected {ushort.MaxValue} at most"), nameof(clip));
        }

        var search = new Search(frames, skeleton, precision);
        return search.Largest(search.Packed);
    }

    private static ClipFrames Frames(IClip clip, int rate, Skeleton skeleton)
    {
        _ = clip ?? throw new ArgumentNullException(nameof(clip));
        _ = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        if (clip.Joints != skeleton.Count || rate < 1)
        {
            throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} of {clip.Joints} joints at {rate} frames per second; expected the {skeleton.Count} joints of the skeleton, and 1 frame at least"), nameof(clip));
        }

        return new ClipFrames(clip, rate);
    }

    /// <summary>Looks for the largest tolerance that keeps to a precision.</summary>
    private sealed class Search
    {
        private readonly ClipFrames frames;
        private readonly Skeleton skeleton;
        private readonly ClipPrecision precision;
        private readonly float[] reaches;
        private readonly ModelPose right;
        private readonly ModelPose shown;

        public Search(ClipFrames frames, Skeleton skeleton, in ClipPrecision precision)
        {
            this.frames = frames;
            this.skeleton = skeleton;
            this.precision = precision;
            right = new ModelPose(skeleton);
            shown = new ModelPose(skeleton);
            reaches = Reaches(skeleton, precision.Distance);
        }

        public T Largest<T>(Func<float, T> make)
            where T : IClip
        {
            double low = PortableMath.Log(SmallestTolerance);
            double high = PortableMath.Log(LargestTolerance);
            T best = make((float)(SmallestTolerance * precision.Error));
            for (int i = 0; i < Halvings; i++)
            {
                double middle = 0.5 * (low + high);
                T next = make((float)(PortableMath.Exp(middle) * precision.Error));
                if (Keeps(next))
                {
                    best = next;
                    low = middle;
                }
                else
                {
                    high = middle;
                }
            }

            return best;
        }

        /// <summary>The clip with the keys of a tolerance.</summary>
        public KeyedClip Keyed(float tolerance)
        {
            var turns = new KeyTrack[skeleton.Count];
            var places = new KeyTrack[skeleton.Count];
            for (int joint = 0; joint < turns.Length; joint++)
            {
                turns[joint] = Track(frames.Rotation(joint), tolerance / (2f * reaches[joint]), turns: true);
                places[joint] = Track(frames.Position(joint), tolerance, turns: false);
            }

            return new KeyedClip(frames.Clip.Name, frames.Clip.End, frames.Clip.Duration, frames.Clip.Speed, turns, places, EventsOf(frames.Clip));
        }

        /// <summary>The same in few bytes.</summary>
        public CompressedClip Packed(float tolerance)
        {
            var writer = new PackedWriter(frames.Count, precision.Interpolation);
            for (int joint = 0; joint < skeleton.Count; joint++)
            {
                float turn = tolerance / (2f * reaches[joint]);
                TrackFrames rotation = frames.Rotation(joint).From(skeleton.LocalRotations[joint]);
                TrackFrames position = frames.Position(joint).From(skeleton.LocalPositions[joint]);
                writer.Turns(rotation, rotation.Choose(precision.Interpolation, turn), turn);
                writer.Places(position, position.Choose(precision.Interpolation, tolerance), tolerance);
            }

            return new CompressedClip(frames.Clip, skeleton, frames.Count, precision.Interpolation, writer.ToArray());
        }

        private static IReadOnlyList<ClipEvent> EventsOf(IClip clip)
        {
            if (clip.EventSpan == clip.Duration)
            {
                return clip.Events;
            }

            var events = new List<ClipEvent>();
            foreach (ClipEvent one in clip.Events)
            {
                events.Add(new ClipEvent(Math.Min(one.Time / clip.EventSpan * clip.Duration, clip.Duration), one.Name, one.Joint, one.Strength));
            }

            return events;
        }

        /// <summary>How far what hangs on each joint reaches from it, metres.</summary>
        private static float[] Reaches(Skeleton skeleton, float distance)
        {
            float[] reaches = new float[skeleton.Count];
            for (int joint = skeleton.Count - 1; joint >= 0; joint--)
            {
                reaches[joint] = Math.Max(reaches[joint], distance);
                for (int above = skeleton.Parents[joint]; above >= 0; above = skeleton.Parents[above])
                {
                    reaches[above] = Math.Max(reaches[above], distance + Vec.Distance(skeleton.ModelPositions[above], skeleton.ModelPositions[joint]));
                }
            }

            return reaches;
        }

        private KeyTrack Track(TrackFrames track, float tolerance, bool turns)
        {
            ChosenKeys keys = track.Choose(precision.Interpolation, tolerance);
            float[] times = Array.ConvertAll(keys.Frames, frames.TimeOf);
            KeyInterpolation interpolation = keys.Count == 1 ? KeyInterpolation.Step : precision.Interpolation;
            return KeyTrack.Of(times, track.At(keys, times, interpolation), interpolation, turns);
        }

        /// <summary>Whether no more than so many cases are worse than allowed: at frames, and as far after each as curves are looked at.</summary>
        private bool Keeps(IClip clip)
        {
            // Straight lines are farthest off at frames, curves anywhere.
            int parts = precision.Interpolation == KeyInterpolation.Cubic ? TrackFrames.Moments : 1;
            for (int part = 0; part < parts; part++)
            {
                if (!Keeps(clip, part, parts))
                {
                    return false;
                }
            }

            return true;
        }

        private bool Keeps(IClip clip, int part, int parts)
        {
            int worse = 0;
            int last = (frames.Count - 1) * parts;
            int allowed = frames.Count * skeleton.Count * WorseOfHundred / 100;
            for (int moment = part; moment <= last && worse <= allowed; moment += parts)
            {
                float time = ClipError.PartOf(frames.Clip.Duration, moment, last + 1);
                right.Sample(frames.Clip, time);
                shown.Sample(clip, time);
                for (int joint = 0; joint < skeleton.Count; joint++)
                {
                    worse += ClipError.At(right, shown, joint, precision.Distance) > precision.Error ? 1 : 0;
                }
            }

            return worse <= allowed;
        }
    }
}
