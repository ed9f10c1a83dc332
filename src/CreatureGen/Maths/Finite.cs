using System;
using System.Numerics;

namespace CreatureGen.Maths;

/// <summary>Refuses numbers that are not numbers where they enter, with one message that names them.</summary>
internal static class Finite
{
    /// <summary>Whether <paramref name="x"/> is neither NaN nor infinite.</summary>
    public static bool Is(float x) => x - x == 0f;

    /// <summary>Whether all parts are finite.</summary>
    public static bool Is(Vector3 v) => ((v.X - v.X) + (v.Y - v.Y) + (v.Z - v.Z)) == 0f;

    /// <summary>Whether all parts are finite.</summary>
    public static bool Is(Quaternion q) => ((q.X - q.X) + (q.Y - q.Y) + (q.Z - q.Z) + (q.W - q.W)) == 0f;

    /// <summary>Throws unless the number is finite.</summary>
    public static void Require(float x, string name)
    {
        if (!Is(x))
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} = {x}; expected a finite number"), name);
        }
    }

    /// <summary>Throws unless all parts are finite.</summary>
    public static void Require(Vector3 v, string name)
    {
        if (!Is(v))
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} = ({v.X}, {v.Y}, {v.Z}); expected finite numbers"), name);
        }
    }

    /// <summary>Throws unless the quaternion is a rotation: finite and of length 1.</summary>
    public static void RequireUnit(Quaternion q, string name)
    {
        float squared = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
        if (!(Math.Abs(squared - 1f) <= 2f * Tolerance.UnitLength))
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} = ({q.X}, {q.Y}, {q.Z}, {q.W}); expected a quaternion of length 1"), name);
        }
    }

    /// <summary>Throws unless the number is finite and lies in the range.</summary>
    public static void RequireWithin(float x, float min, float max, string name)
    {
        if (!(x >= min && x <= max))
        {
            throw new ArgumentOutOfRangeException(name, FormattableString.Invariant($"{name} = {x}; expected {min} to {max}"));
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
    public static void RequireUnit(Vector3 v, string name)
    {
        if (!(Math.Abs(Vec.LengthSquared(v) - 1f) <= 2f * Tolerance.UnitLength))
        {
            throw new ArgumentException(FormattableString.Invariant($"{name} = ({v.X}, {v.Y}, {v.Z}); expected a vector of length 1"), name);
        }
    }

    /// <summary>Throws unless the time step is finite and not negative.</summary>
    public static void RequireStep(float seconds)
    {
        if (!(seconds >= 0f && seconds <= float.MaxValue))
        {
            throw new ArgumentOutOfRangeException(nameof(seconds), FormattableString.Invariant($"a time step of {seconds} s; expected a finite number not below 0"));
        }
    }
}
