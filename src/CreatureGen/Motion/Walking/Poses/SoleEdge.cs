using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>A foot that holds on to the edge of its sole on which it stands, whichever that is: on level ground what of the sole is down stays where it would be if the foot lay as it should.</summary>
internal static class SoleEdge
{
    /// <summary>Height above the lowest point of the sole at which another counts half as much as it, leg lengths: as a foot rolls from one edge to the next its hold goes over softly.</summary>
    private const float Touch = 0.02f;

    /// <summary>Up part of the normal of ground on which a foot holds on to the edge that it stands on, wholly and not at all: 1° and 4°.</summary>
    private const float Level = 0.99985f;
    private const float Slanting = 0.9976f;

    /// <summary>How much it does so, 0..1; a foot that follows its leg does not.</summary>
    public static float Weight(LegRig leg, Vector3 normal) => leg.Follows ? 0f : Scalar.Smooth((normal.Y - Slanting) / (Level - Slanting));

    /// <summary>How far the ball has to go for what touches the ground to stay where it was.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="before">The outline of the sole as it should lie.</param>
    /// <param name="after">The same as its joints allow.</param>
    /// <param name="normal">Of the ground, unit, model space.</param>
    /// <param name="lowest">How far the lowest of the latter is along the normal.</param>
    public static Vector3 Way(LegRig leg, ReadOnlySpan<Vector3> before, ReadOnlySpan<Vector3> after, Vector3 normal, float lowest)
    {
        float touch = Touch * leg.Length;
        Vector3 way = default;
        float sum = 0f;
        for (int i = 0; i < after.Length; i++)
        {
            float above = (Vec.Dot(normal, after[i]) - lowest) / touch;
            float weight = 1f / (1f + (above * above));
            weight *= weight;
            way += (before[i] - after[i]) * weight;
            sum += weight;
        }

        return way / sum;
    }

    /// <summary>Where the outline of the sole is from the ball: what the ankle moves of it with the foot, all else with the toes.</summary>
    /// <returns>How far the lowest of it is along the normal.</returns>
    public static float Lay(LegRig leg, Vector3 normal, Quaternion foot, Quaternion toes, Span<Vector3> points)
    {
        float lowest = float.MaxValue;
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = Rotation.Rotate((leg.Hinder & (1 << i)) != 0 ? foot : toes, leg.Sole[i]);
            lowest = Math.Min(lowest, Vec.Dot(normal, points[i]));
        }

        return lowest;
    }
}
