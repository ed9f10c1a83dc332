using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>A capsule around a bone, where the bone lies when a swimmer's legs are folded; model space, metres.</summary>
internal readonly struct FoldedBone
{
    private readonly Vector3 start;
    private readonly Vector3 end;
    private readonly float radius;

    /// <summary>Puts a bone somewhere.</summary>
    /// <param name="number">Which of its limb's it is.</param>
    /// <param name="capsule">Around it, in its joint's space.</param>
    /// <param name="position">Of the joint.</param>
    /// <param name="rotation">Of the joint.</param>
    public FoldedBone(int number, CapsuleCollider capsule, Vector3 position, Quaternion rotation)
    {
        Number = number;
        start = position + Rotation.Rotate(rotation, capsule.Start);
        end = position + Rotation.Rotate(rotation, capsule.End);
        radius = capsule.Radius;
    }

    /// <summary>Which of its limb's it is, 0 the girdle.</summary>
    public int Number { get; }

    /// <summary>How deep it goes into another, metres; negative is the gap between them.</summary>
    public float DepthIn(in FoldedBone other) => radius + other.radius - (float)Math.Sqrt(SegmentDistance.Squared(start, end, other.start, other.end));
}
