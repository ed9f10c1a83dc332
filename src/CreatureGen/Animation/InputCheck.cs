using System;
using System.Numerics;

namespace CreatureGen.Animation;

/// <summary>Checks at the door of the animator: what comes in is finite and within its range.</summary>
internal static class InputCheck
{
    /// <summary>Passes a finite number.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not finite.</exception>
    public static void Finite(float value, string name)
    {
        if (!float.IsFinite(value))
        {
            throw new ArgumentOutOfRangeException(name, value, "expected a finite number");
        }
    }

    /// <summary>Passes a finite vector.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A component is not finite.</exception>
    public static void Finite(Vector3 value, string name)
    {
        if (!float.IsFinite(value.X) || !float.IsFinite(value.Y) || !float.IsFinite(value.Z))
        {
            throw new ArgumentOutOfRangeException(name, FormattableString.Invariant($"({value.X}, {value.Y}, {value.Z})"), "expected finite numbers");
        }
    }

    /// <summary>Passes a number within bounds.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is outside, or not a number.</exception>
    public static void Within(float value, float least, float most, string name)
    {
        if (!(value >= least && value <= most))
        {
            throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"expected {least}..{most}"));
        }
    }

    /// <summary>Passes a unit quaternion.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not one.</exception>
    public static void Unit(Quaternion value, string name)
    {
        float squared = (value.X * value.X) + (value.Y * value.Y) + (value.Z * value.Z) + (value.W * value.W);
        if (!(squared > 0.998f && squared < 1.002f))
        {
            throw new ArgumentOutOfRangeException(name, FormattableString.Invariant($"({value.X}, {value.Y}, {value.Z}, {value.W})"), "expected a unit quaternion");
        }
    }
}
