using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>Rotations and positions as 48 bits: three numbers of 16, of rotations three digits and which component is left out.</summary>
/// <remarks>Based on: the "smallest three" of G. Fiedler, "Snapshot compression" (2015), with the range of the track in place of ±√½ and digits in place of bits, of which there would be 15 and one to spare.</remarks>
internal static class PackedValue
{
    /// <summary>Steps of a component of a rotation, to either side of 0.</summary>
    private const int TurnSteps = 20642;

    /// <summary>Values of a component of a rotation: the most of which three, and four choices of what is left out, fit into 48 bits.</summary>
    private const uint TurnValues = (2 * TurnSteps) + 1;

    /// <summary>Steps of a component of a position, to either side of 0.</summary>
    private const int PlaceSteps = 0x7FFF;

    /// <summary>The largest magnitude among the components that a rotation keeps.</summary>
    public static float RangeOf(Quaternion q)
    {
        int largest = Largest(q);
        float range = 0f;
        for (int k = 1; k < 4; k++)
        {
            range = Math.Max(range, Math.Abs(Component(q, (largest + k) & 3)));
        }

        return range;
    }

    /// <summary>Packs a rotation.</summary>
    public static (ushort A, ushort B, ushort C) Pack(Quaternion q, float range)
    {
        int largest = Largest(q);
        float sign = Component(q, largest) < 0f ? -1f : 1f;
        int a = Whole(sign * Component(q, (largest + 1) & 3), range, TurnSteps);
        int b = Whole(sign * Component(q, (largest + 2) & 3), range, TurnSteps);
        int c = Whole(sign * Component(q, (largest + 3) & 3), range, TurnSteps);

        ulong number = ((((((ulong)c * TurnValues) + (uint)b) * TurnValues) + (uint)a) << 2) | (uint)largest;
        return ((ushort)number, (ushort)(number >> 16), (ushort)(number >> 32));
    }

    /// <summary>Unpacks a rotation.</summary>
    public static Quaternion Turn(ushort a, ushort b, ushort c, float range)
    {
        ulong number = a | ((ulong)b << 16) | ((ulong)c << 32);
        ulong above = (number >> 2) / TurnValues;
        uint last = (uint)(above / TurnValues);
        float step = range / TurnSteps;
        float x = ((int)((number >> 2) - (above * TurnValues)) - TurnSteps) * step;
        float y = ((int)(above - ((ulong)last * TurnValues)) - TurnSteps) * step;
        float z = ((int)last - TurnSteps) * step;
        float w = (float)Math.Sqrt(Math.Max(0f, 1f - (x * x) - (y * y) - (z * z)));
        return ((int)number & 3) switch
        {
            0 => new Quaternion(w, x, y, z),
            1 => new Quaternion(z, w, x, y),
            2 => new Quaternion(y, z, w, x),
            _ => new Quaternion(x, y, z, w),
        };
    }

    /// <summary>Packs a position.</summary>
    public static (ushort A, ushort B, ushort C) Pack(Vector3 p, float range) =>
        ((ushort)Whole(p.X, range, PlaceSteps), (ushort)Whole(p.Y, range, PlaceSteps), (ushort)Whole(p.Z, range, PlaceSteps));

    /// <summary>Unpacks a position.</summary>
    public static Vector3 Place(ushort a, ushort b, ushort c, float range) =>
        new Vector3(a - PlaceSteps, b - PlaceSteps, c - PlaceSteps) * (range / PlaceSteps);

    private static int Whole(float x, float range, int steps) =>
        range > 0f ? (int)Scalar.Clamp(Math.Round((double)x / range * steps) + steps, 0, 2 * steps) : steps;

    private static int Largest(Quaternion q)
    {
        int largest = 3;
        for (int k = 0; k < 3; k++)
        {
            largest = Math.Abs(Component(q, k)) > Math.Abs(Component(q, largest)) ? k : largest;
        }

        return largest;
    }

    private static float Component(Quaternion q, int k) => k switch { 0 => q.X, 1 => q.Y, 2 => q.Z, _ => q.W };
}
