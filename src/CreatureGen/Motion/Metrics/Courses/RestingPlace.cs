using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Where a creature and its feet are at the end of a course, world space.</summary>
/// <param name="Root">Its root.</param>
/// <param name="Feet">On the ground below the balls of its feet, or where those that take a last step are going; empty for what is not on its feet.</param>
/// <param name="LegLength">Metres.</param>
internal sealed record RestingPlace(Vector3 Root, IReadOnlyList<Vector3> Feet, float LegLength)
{
    /// <summary>How far a foot is from where it is in another at most, leg lengths; null without feet in both.</summary>
    public float? FootSpread(RestingPlace other)
    {
        float max = 0f;
        for (int i = 0; i < Math.Min(Feet.Count, other.Feet.Count); i++)
        {
            max = Math.Max(max, Vec.Distance(Feet[i], other.Feet[i]));
        }

        return Feet.Count > 0 && Feet.Count == other.Feet.Count ? max / LegLength : null;
    }

    /// <summary>How far the root is from where it is in another, leg lengths; null without legs.</summary>
    public float? RootSpread(RestingPlace other) => LegLength > 0f ? Vec.Distance(Root, other.Root) / LegLength : null;
}
