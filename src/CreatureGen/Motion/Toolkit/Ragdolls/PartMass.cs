using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>Volume, centre and extent of capsules that make one part; density does not matter, since only shares of the whole are used.</summary>
internal struct PartMass
{
    private Vector3 moment;
    private Vector3 min;
    private Vector3 max;

    /// <summary>Cubic model metres.</summary>
    public float Volume { get; private set; }

    /// <summary>Centre of mass; the joint itself without a capsule.</summary>
    public readonly Vector3 Centre => Volume > 0f ? moment / Volume : Vector3.Zero;

    /// <summary>Adds a capsule.</summary>
    public void Add(CapsuleCollider capsule)
    {
        float r = capsule.Radius;
        float length = Vec.Distance(capsule.Start, capsule.End);
        float volume = (float)(PortableMath.Pi * r * r * (length + (4f / 3f * r)));
        Vector3 radius = new(r, r, r);
        Vector3 low = Min(capsule.Start, capsule.End) - radius;
        Vector3 high = Max(capsule.Start, capsule.End) + radius;
        bool first = Volume == 0f;
        min = first ? low : Min(min, low);
        max = first ? high : Max(max, high);
        moment += (capsule.Start + capsule.End) * (0.5f * volume);
        Volume += volume;
    }

    /// <summary>Moments of inertia of an ellipsoid of the same extent, none thinner than a share of the longest axis.</summary>
    /// <param name="stoutness">Least axis over longest.</param>
    /// <param name="mass">Of the part.</param>
    /// <param name="minHalfAxis">No half axis is shorter.</param>
    public readonly Vector3 Inertia(float stoutness, float mass, float minHalfAxis)
    {
        Vector3 half = (max - min) * 0.5f;
        float longest = Math.Max(half.X, Math.Max(half.Y, half.Z));
        half = Max(half, new Vector3(Math.Max(longest * stoutness, minHalfAxis)));
        Vector3 squares = half * half * (mass / 5f);
        return new Vector3(squares.Y + squares.Z, squares.X + squares.Z, squares.X + squares.Y);
    }

    private static Vector3 Min(Vector3 a, Vector3 b) => new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));

    private static Vector3 Max(Vector3 a, Vector3 b) => new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));
}
