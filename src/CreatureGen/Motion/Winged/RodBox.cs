using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>A box along the axes about a capsule and what is near to it.</summary>
internal readonly struct RodBox
{
    public RodBox(Vector3 min, Vector3 max)
    {
        Min = min;
        Max = max;
    }

    public Vector3 Min { get; }

    public Vector3 Max { get; }

    /// <summary>Whether a point is in it, or below it where that counts.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool MayHold(Vector3 point, bool below) =>
        point.X >= Min.X && point.X <= Max.X && point.Z >= Min.Z && point.Z <= Max.Z && point.Y <= Max.Y && (below || point.Y >= Min.Y);

    /// <summary>The square of how far a point is out of it; 0 within.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float AwaySquared(Vector3 point)
    {
        return Vec.LengthSquared(Vec.Max(Vector3.Zero, Vec.Max(Min - point, point - Max)));
    }
}
