using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Clips;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Keys of one rotation or one position over time: times in ascending order and a value at each. Before the first key and after the last it stays. Immutable.</summary>
/// <remarks>Based on: the animation samplers of glTF 2.0 (Khronos Group, 2021), appendix C; K. Shoemake, "Animating rotation with quaternion curves" (1985).</remarks>
public sealed class KeyTrack
{
    private readonly float[] times;
    private readonly Vector4[] values;
    private readonly bool turns;

    private KeyTrack(float[] times, Vector4[] values, KeyInterpolation interpolation, bool turns)
    {
        int each = interpolation == KeyInterpolation.Cubic ? 3 : 1;
        if (times.Length == 0 || values.Length != each * times.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{times.Length} times and {values.Length} values; expected {each} for each time, and one time at least"), nameof(values));
        }

        Require(interpolation);

        for (int i = 0; i < times.Length; i++)
        {
            if (!Finite.Is(times[i]) || times[i] < 0f || (i > 0 && times[i] <= times[i - 1]))
            {
                throw new ArgumentException(FormattableString.Invariant($"time {i} is {times[i]} s; expected finite times of 0 and more, each later than the one before"), nameof(times));
            }
        }

        this.times = times;
        this.values = values;
        this.turns = turns;
        Interpolation = interpolation;
        Prove(each);
    }

    /// <summary>How it goes from key to key.</summary>
    public KeyInterpolation Interpolation { get; }

    /// <summary>Seconds, ascending.</summary>
    public ReadOnlySpan<float> Times => times;

    /// <summary>Values as they are kept: those of cubic tracks between their tangents.</summary>
    internal ReadOnlySpan<Vector4> Values => values;

    /// <summary>Number of keys.</summary>
    public int Count => times.Length;

    /// <summary>A track of rotations.</summary>
    /// <param name="times">Seconds, ascending from 0 or later. The arrays become the track's own.</param>
    /// <param name="rotations">Unit quaternions, one for each time; of cubic tracks three: tangent before, value, tangent after, tangents per second.</param>
    /// <param name="interpolation">How it goes from key to key.</param>
    /// <exception cref="ArgumentException">Lengths differ, times do not ascend, or a number is not finite or a quaternion not of unit length.</exception>
    public static KeyTrack OfRotations(float[] times, ReadOnlySpan<Quaternion> rotations, KeyInterpolation interpolation)
    {
        var values = new Vector4[rotations.Length];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = new Vector4(rotations[i].X, rotations[i].Y, rotations[i].Z, rotations[i].W);
        }

        return new KeyTrack(times ?? throw new ArgumentNullException(nameof(times)), values, interpolation, turns: true);
    }

    /// <summary>A track of positions.</summary>
    /// <param name="times">Seconds, ascending from 0 or later. The arrays become the track's own.</param>
    /// <param name="positions">Metres, one for each time; of cubic tracks three: tangent before, value, tangent after, tangents per second.</param>
    /// <param name="interpolation">How it goes from key to key.</param>
    /// <exception cref="ArgumentException">Lengths differ, times do not ascend, or a number is not finite.</exception>
    public static KeyTrack OfPositions(float[] times, ReadOnlySpan<Vector3> positions, KeyInterpolation interpolation)
    {
        var values = new Vector4[positions.Length];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = new Vector4(positions[i], 0f);
        }

        return new KeyTrack(times ?? throw new ArgumentNullException(nameof(times)), values, interpolation, turns: false);
    }

    /// <summary>A track of values as they are kept: those of cubic tracks between their tangents.</summary>
    internal static KeyTrack Of(float[] times, Vector4[] values, KeyInterpolation interpolation, bool turns) => new(times, values, interpolation, turns);

    /// <summary>Throws unless there is such an interpolation.</summary>
    internal static void Require(KeyInterpolation interpolation)
    {
        if (!Enum.IsDefined(typeof(KeyInterpolation), interpolation))
        {
            throw new ArgumentException(FormattableString.Invariant($"interpolation {(int)interpolation}; expected step, linear or cubic"), nameof(interpolation));
        }
    }

    /// <summary>The last key at or before a time, 0 if there is none.</summary>
    /// <param name="time">Seconds.</param>
    /// <param name="guess">Where to look first: the key of the last question.</param>
    internal int KeyAt(float time, int guess)
    {
        if (guess < times.Length && times[guess] <= time)
        {
            // Time mostly goes on by a key or less.
            for (int next = guess + 1; next <= guess + 2; next++)
            {
                if (next >= times.Length || times[next] > time)
                {
                    return next - 1;
                }
            }
        }

        int low = 0;
        int high = times.Length - 1;
        while (low < high)
        {
            int middle = (low + high + 1) >> 1;
            if (times[middle] <= time)
            {
                low = middle;
            }
            else
            {
                high = middle - 1;
            }
        }

        return low;
    }

    /// <summary>Whether another track has the same times in the same memory, so that one search serves both.</summary>
    internal bool SharesTimes(KeyTrack other) => ReferenceEquals(times, other.times);

    /// <summary>The rotation at a time.</summary>
    internal Quaternion RotationAt(float time, int key)
    {
        if (IsHeld(time, key, out float fraction, out float seconds))
        {
            return ToQuaternion(ValueAt(key));
        }

        if (Interpolation == KeyInterpolation.Linear)
        {
            return Rotation.Slerp(ToQuaternion(values[key]), ToQuaternion(values[key + 1]), fraction);
        }

        return Rotation.Normalize(ToQuaternion(Curve(key, fraction, seconds)));
    }

    /// <summary>The position at a time.</summary>
    internal Vector3 PositionAt(float time, int key)
    {
        if (IsHeld(time, key, out float fraction, out float seconds))
        {
            return ToVector(ValueAt(key));
        }

        return Interpolation == KeyInterpolation.Linear
            ? Vec.Lerp(ToVector(values[key]), ToVector(values[key + 1]), fraction)
            : ToVector(Curve(key, fraction, seconds));
    }

    private static Quaternion ToQuaternion(Vector4 v) => new(v.X, v.Y, v.Z, v.W);

    private static Vector3 ToVector(Vector4 v) => new(v.X, v.Y, v.Z);

    /// <summary>The value of a key.</summary>
    internal Vector4 ValueAt(int key) => values[Interpolation == KeyInterpolation.Cubic ? (3 * key) + 1 : key];

    /// <summary>Whether the value at a time is that of a key; otherwise how far it is towards the next key.</summary>
    private bool IsHeld(float time, int key, out float fraction, out float seconds)
    {
        fraction = seconds = 0f;
        if (key + 1 >= times.Length || time <= times[key] || Interpolation == KeyInterpolation.Step)
        {
            return true;
        }

        seconds = times[key + 1] - times[key];
        fraction = (time - times[key]) / seconds;
        return false;
    }

    private Vector4 Curve(int key, float t, float seconds) =>
        KeyCurve.At(values[(3 * key) + 1], values[(3 * key) + 2], values[(3 * key) + 3], values[(3 * key) + 4], t, seconds);

    private void Prove(int each)
    {
        for (int i = 0; i < values.Length; i++)
        {
            Vector4 v = values[i];
            float squared = (v.X * v.X) + (v.Y * v.Y) + (v.Z * v.Z) + (v.W * v.W);
            bool value = each == 1 || i % 3 == 1;
            if (!Finite.Is(squared) || (turns && value && !(Math.Abs(squared - 1f) <= 2f * Tolerance.UnitLength)))
            {
                throw new ArgumentException(FormattableString.Invariant($"value {i} is ({v.X}, {v.Y}, {v.Z}, {v.W}); expected {(turns ? "unit quaternions" : "finite numbers")}"), "values");
            }
        }
    }
}
