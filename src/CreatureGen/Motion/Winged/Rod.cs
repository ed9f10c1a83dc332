using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>A capsule.</summary>
internal readonly record struct Rod(Vector3 Start, Vector3 End, float Radius)
{
    public Rod Turned(Vector3 pivot, Quaternion turn) => new(pivot + Rotation.Rotate(turn, Start - pivot), pivot + Rotation.Rotate(turn, End - pivot), Radius);

    /// <summary>The box about all that is nearer to it than a distance.</summary>
    public RodBox Box(float distance)
    {
        var around = new Vector3(Radius + distance);
        return new RodBox(Vec.Min(Start, End) - around, Vec.Max(Start, End) + around);
    }

    /// <summary>How far a point is above it, negative below; or as far beside it as it is.</summary>
    public double Above(Vector3 point)
    {
        var way = new Vector3(End.X - Start.X, 0f, End.Z - Start.Z);
        float squared = Vec.LengthSquared(way);
        var from = new Vector3(point.X - Start.X, 0f, point.Z - Start.Z);
        float along = squared > 0f ? Scalar.Clamp(Vec.Dot(from, way) / squared, 0f, 1f) : 0f;
        return Math.Max(Vec.Length(from - (way * along)), point.Y - Scalar.Lerp(Start.Y, End.Y, along)) - Radius;
    }

    /// <summary>From its surface to a point, negative within.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Distance(Vector3 point)
    {
        Vector3 way = End - Start;
        float squared = Vec.LengthSquared(way);
        float along = squared > 0f ? Scalar.Clamp(Vec.Dot(point - Start, way) / squared, 0f, 1f) : 0f;
        return Vec.Distance(point, Start + Vec.Scale(way, along)) - Radius;
    }
}
