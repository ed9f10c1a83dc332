using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>A rotation or a position of one joint in every frame of a clip, from which the keys of a track are chosen.</summary>
internal sealed class TrackFrames
{
    /// <summary>Moments in a frame at which curves are looked at.</summary>
    public const int Moments = 4;

    private readonly Vector4[] values;
    private readonly bool turns;
    private readonly bool loops;

    /// <summary>Takes the frames.</summary>
    /// <param name="values">Of each frame; signs of rotations do not jump.</param>
    /// <param name="turns">Whether they are rotations.</param>
    /// <param name="loops">Whether the last is the first again.</param>
    public TrackFrames(Vector4[] values, bool turns, bool loops)
    {
        this.values = values;
        this.turns = turns;
        this.loops = loops;
    }

    /// <summary>Of each frame.</summary>
    public ReadOnlySpan<Vector4> Values => values;

    /// <summary>A track of rotations as what turns a joint from another rotation.</summary>
    public TrackFrames From(Quaternion other)
    {
        Quaternion back = Rotation.Inverse(other);
        return new TrackFrames(Array.ConvertAll(values, v => ToVector(Rotation.Multiply(back, ToQuaternion(v)))), turns, loops);
    }

    /// <summary>A track of positions as what moves a joint from another position.</summary>
    public TrackFrames From(Vector3 other) => new(Array.ConvertAll(values, v => v - new Vector4(other, 0f)), turns, loops);

    /// <summary>Chooses the frames that become keys, as few as will do; the first and the last are among them, but of a track that does not move only the first.</summary>
    /// <param name="interpolation">How the track goes from key to key.</param>
    /// <param name="tolerance">Most by which it may be off, at frames and between them: metres, or parts of a unit quaternion, which are half of radians.</param>
    public ChosenKeys Choose(KeyInterpolation interpolation, float tolerance)
    {
        if (Reaches(KeyInterpolation.Step, 0, values.Length, tolerance))
        {
            return new ChosenKeys(new[] { 0 }, Array.Empty<bool>());
        }

        return interpolation == KeyInterpolation.Cubic ? Insert(tolerance) : new ChosenKeys(Stride(interpolation, tolerance), Array.Empty<bool>());
    }

    /// <summary>Values of keys in their order, with the tangents of a cubic track around each as <see cref="KeyTrack"/> takes them.</summary>
    public Vector4[] At(ChosenKeys keys, float[] times, KeyInterpolation interpolation)
    {
        int[] frames = keys.Frames;
        if (interpolation != KeyInterpolation.Cubic)
        {
            return Array.ConvertAll(frames, frame => values[frame]);
        }

        var chosen = new Vector4[3 * keys.Count];
        for (int k = 0; k < keys.Count; k++)
        {
            Vector4 smooth = KeyCurve.Tangent(k, keys.Count, loops, i => values[frames[i]], i => times[i]);
            chosen[3 * k] = keys.GoesStraight(k - 1) ? Straight(frames[k - 1], frames[k]).Arriving * (1f / (times[k] - times[k - 1])) : smooth;
            chosen[(3 * k) + 1] = values[frames[k]];
            chosen[(3 * k) + 2] = keys.GoesStraight(k) ? Straight(frames[k], frames[k + 1]).Leaving * (1f / (times[k + 1] - times[k])) : smooth;
        }

        return chosen;
    }

    /// <summary>From key to key as far as the frames between allow.</summary>
    private int[] Stride(KeyInterpolation interpolation, float tolerance)
    {
        var keys = new List<int> { 0 };
        int last = values.Length - 1;
        for (int from = 0; from < last;)
        {
            // Twice as far as long as it will do, then halfway back.
            int good = from + 1;
            int step = 2;
            while (from + step <= last && Reaches(interpolation, from, from + step, tolerance))
            {
                good = from + step;
                step *= 2;
            }

            int bad = Math.Min(from + step, last + 1);
            while (bad - good > 1)
            {
                int middle = (good + bad) / 2;
                if (Reaches(interpolation, from, middle, tolerance))
                {
                    good = middle;
                }
                else
                {
                    bad = middle;
                }
            }

            keys.Add(good);
            from = good;
        }

        return keys.ToArray();
    }

    /// <summary>Whether all frames between two keys are near enough to what goes from one to the other.</summary>
    private bool Reaches(KeyInterpolation interpolation, int from, int to, float tolerance)
    {
        for (int i = from + 1; i < to; i++)
        {
            Vector4 shown = interpolation == KeyInterpolation.Step ? values[from] : Between(from, to, (i - from) / (float)(to - from));
            if (!IsNear(shown, values[i], tolerance))
            {
                return false;
            }
        }

        return true;
    }

    private Vector4 Between(int from, int to, float t)
    {
        Vector4 a = values[from];
        Vector4 b = values[to];
        if (!turns)
        {
            return a + ((b - a) * t);
        }

        return ToVector(Rotation.Nlerp(ToQuaternion(a), ToQuaternion(b), t));
    }

    /// <summary>Key by key where the track is farthest off, until it is nowhere too far.</summary>
    private ChosenKeys Insert(float tolerance)
    {
        // A loop that had keys at its ends alone would stand still.
        var keys = new List<int> { 0, values.Length - 1 };
        if (values.Length > 2)
        {
            keys.Insert(1, values.Length / 2);
        }

        var straight = new List<bool>();
        var added = new List<int>();
        do
        {
            added.Clear();
            straight.Clear();
            for (int k = 0; k + 1 < keys.Count; k++)
            {
                bool curved = IsCurveNear(keys, k, tolerance, out int worst);
                straight.Add(!curved && Reaches(KeyInterpolation.Linear, keys[k], keys[k + 1], tolerance));
                if (!curved && !straight[k])
                {
                    added.Add(worst);
                }
            }

            keys.AddRange(added);
            keys.Sort();
        }
        while (added.Count > 0);

        return new ChosenKeys(keys.ToArray(), straight.ToArray());
    }

    /// <summary>Whether the curve between two keys is nowhere too far off what goes straight from frame to frame.</summary>
    /// <param name="keys">All keys.</param>
    /// <param name="k">The first of the two.</param>
    /// <param name="tolerance">Most by which it may be off.</param>
    /// <param name="worst">The frame between them that is nearest to where it is farthest off.</param>
    private bool IsCurveNear(List<int> keys, int k, float tolerance, out int worst)
    {
        int from = keys[k];
        int to = keys[k + 1];
        Vector4 leaving = KeyCurve.Tangent(k, keys.Count, loops, i => values[keys[i]], i => keys[i]);
        Vector4 arriving = KeyCurve.Tangent(k + 1, keys.Count, loops, i => values[keys[i]], i => keys[i]);
        float max = 0f;
        worst = from + 1;
        for (int i = 1; i < (to - from) * Moments; i++)
        {
            int frame = from + (i / Moments);
            Vector4 shown = KeyCurve.At(values[from], leaving, arriving, values[to], i / (float)((to - from) * Moments), to - from);
            Vector4 right = i % Moments == 0 ? values[frame] : Between(frame, frame + 1, i % Moments / (float)Moments);
            float off = Off(turns ? KeyCurve.Unit(shown) : shown, right);
            if (off > max)
            {
                max = off;
                worst = Math.Min(Math.Max(from + ((i + (Moments / 2)) / Moments), from + 1), to - 1);
            }
        }

        return max <= tolerance * tolerance;
    }

    /// <summary>The tangents, per way from one frame to another, with which a cubic curve goes straight between them: along the great circle of rotations.</summary>
    private (Vector4 Leaving, Vector4 Arriving) Straight(int from, int to)
    {
        Vector4 a = values[from];
        Vector4 b = values[to];
        if (!turns)
        {
            return (b - a, b - a);
        }

        double cosine = Scalar.Clamp((a.X * (double)b.X) + (a.Y * (double)b.Y) + (a.Z * (double)b.Z) + (a.W * (double)b.W), 0, 1);
        double angle = PortableMath.Acos(cosine);
        float longer = angle < 1e-3 ? 1f : (float)(angle / PortableMath.Sin(angle));
        return ((b - (a * (float)cosine)) * longer, ((b * (float)cosine) - a) * longer);
    }

    private static Quaternion ToQuaternion(Vector4 q) => new(q.X, q.Y, q.Z, q.W);

    private static Vector4 ToVector(Quaternion q) => new(q.X, q.Y, q.Z, q.W);

    private bool IsNear(Vector4 a, Vector4 b, float tolerance) => Off(a, b) <= tolerance * tolerance;

    private float Off(Vector4 a, Vector4 b)
    {
        float off = KeyCurve.SquaredDistance(a, b);
        return turns ? Math.Min(off, KeyCurve.SquaredDistance(a, b * -1f)) : off;
    }
}
