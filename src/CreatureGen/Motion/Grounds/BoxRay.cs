using System;
using System.Numerics;

namespace CreatureGen.Motion.Grounds;

/// <summary>A ray that is held against many boxes.</summary>
/// <remarks>Based on: T. L. Kay and J. T. Kajiya, "Ray tracing complex scenes" (1986), with the reciprocals of the direction worked out once.</remarks>
internal readonly struct BoxRay
{
    // Of a direction that goes along an axis's planes; finite, so that 0 times it is 0.
    private const float Along = float.MaxValue;
    private const float SmallestPart = 1e-12f;

    // Boxes begin this much earlier than they do, relative and in metres: rounding must not hide a triangle.
    private const float Slack = 0.999999f;
    private const float SlackMetres = 1e-6f;

    private readonly Vector3 origin;
    private readonly Vector3 reciprocal;

    public BoxRay(Vector3 origin, Vector3 direction)
    {
        this.origin = origin;
        reciprocal = new Vector3(Reciprocal(direction.X), Reciprocal(direction.Y), Reciprocal(direction.Z));
    }

    /// <summary>How far along the ray a box begins at the earliest, metres; infinite if the ray does not meet it within a distance.</summary>
    public float Enters(in BoxNode box, float distance)
    {
        Vector3 a = (box.Min - origin) * reciprocal;
        Vector3 b = (box.Max - origin) * reciprocal;
        float enter = Math.Max(Math.Max(0f, Math.Min(a.X, b.X)), Math.Max(Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z)));
        float leave = Math.Min(Math.Min(distance, Math.Max(a.X, b.X)), Math.Min(Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z)));
        float earliest = (enter * Slack) - SlackMetres;
        return earliest <= leave ? earliest : float.PositiveInfinity;
    }

    private static float Reciprocal(float part) => Math.Abs(part) < SmallestPart ? Along : 1f / part;
}
