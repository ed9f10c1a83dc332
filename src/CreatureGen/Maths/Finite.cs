using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Refuses numbers that are not numbers where they enter, with one message that names them.</summary>
/// <remarks>The tests are written out where they are called, and the messages are not: so they cost next to nothing also where code is compiled ahead, without a profile of what is called how often.</remarks>
internal static class Finite
{
    /// <summary>Whether <paramref name="x"/> is neither NaN nor infinite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Is(float x) => x - x == 0f;

    /// <summary>Whether all parts are finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Is(Vector3 v) => ((v.X - v.X) + (v.Y - v.Y) + (v.Z - v.Z)) == 0f;

    /// <summary>Whether all parts are finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Is(Quaternion q) => ((q.X - q.X) + (q.Y - q.Y) + (q.Z - q.Z) + (q.W - q.W)) == 0f;

    /// <summary>Throws unless the number is finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Require(float x, string name)
    {
        if (!Is(x))
        {
            throw NotFinite(x, name);
        }
    }

    /// <summary>Throws unless all parts are finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Require(Vector3 v, string name)
    {
        if (!Is(v))
        {
            throw NotFinite(v, name);
        }
    }

    /// <summary>Throws unless the quaternion is a rotation: finite and of length 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void RequireUnit(Quaternion q, string name)
    {
        float squared = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
        if (!(Math.Abs(squared - 1f) <= 2f * Tolerance.UnitLength))
        {
            throw NotUnit(q, name);
        }
    }

    /// <summary>Throws unless the number is finite and lies in the range.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void RequireWithin(float x, float min, float max, string name)
    {
        if (!(x >= min && x <= max))
        {
            throw Outside(x, min, max, name);
        }
    }

    /// <summary>Throws unless all parts are finite and at most <paramref name="max"/> in size.</summary>
    public static void RequireWithin(Vector3 v, float max, string name)
    {
        if (!(Math.Abs(v.X) <= max && Math.Abs(v.Y) <= max && Math.Abs(v.Z) <= max))
        {
            throw new ArgumentOutOfRangeException(name, FormattableString.Invariant($"{name} = ({v.X}, {v.Y}, {v.Z}); expected numbers of {-max} to {max}"));
        }
    }

    /// <summary>Throws unless the vector is of length 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void RequireUnit(Vector3 v, string name)
    {
        if (!(Math.Abs(Vec.LengthSquared(v) - 1f) <= 2f * Tolerance.UnitLength))
        {
            throw NotUnit(v, name);
        }
    }

    /// <summary>Throws unless the time step is finite and not negative.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void RequireStep(float seconds)
    {
        if (!(seconds >= 0f && seconds <= float.MaxValue))
        {
            throw NoStep(seconds);
        }
    }

    private static ArgumentException NotFinite(float x, string name) => new(FormattableString.Invariant($"{name} = {x}; expected a finite number"), name);

    private static ArgumentException NotFinite(Vector3 v, string name) => new(FormattableString.Invariant($"{name} = ({v.X}, {v.Y}, {v.Z}); expected finite numbers"), name);

    private static ArgumentException NotUnit(Quaternion q, string name) => new(FormattableString.Invariant($"{name} = ({q.X}, {q.Y}, {q.Z}, {q.W}); expected a quaternion of length 1"), name);

    private static ArgumentOutOfRangeException Outside(float x, float min, float max, string name) => new(name, FormattableString.Invariant($"{name} = {x}; expected {min} to {max}"));

    private static ArgumentException NotUnit(Vector3 v, string name) => new(FormattableString.Invariant($"{name} = ({v.X}, {v.Y}, {v.Z}); expected a vector of length 1"), name);

    private static ArgumentOutOfRangeException NoStep(float seconds) => new(nameof(seconds), FormattableString.Invariant($"a time step of {seconds} s; expected a finite number not below 0"));
}
