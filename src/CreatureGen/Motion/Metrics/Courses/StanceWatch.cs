using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Watches the sole of one foot over its stances: from update to update, how far that touching vertex went over the ground which moved least.</summary>
internal sealed class StanceWatch
{
    /// <summary>Leg lengths above the ground, or above the lowest vertex of a foot that floats, within which a vertex touches.</summary>
    private const float Touch = 0.005f;

    private readonly float touch;
    private readonly Vector3[] last;
    private readonly bool[] touched;
    private bool stands;
    private int updates;
    private float way;

    /// <summary>Watches a foot.</summary>
    /// <param name="count">Number of its vertices.</param>
    /// <param name="legLength">Metres.</param>
    public StanceWatch(int count, float legLength)
    {
        touch = Touch * legLength;
        last = new Vector3[count];
        touched = new bool[count];
    }

    /// <summary>An update of a stance.</summary>
    /// <param name="points">The vertices, in axes that go along with the ground, metres.</param>
    /// <param name="heights">Above the ground, metres.</param>
    /// <param name="lowest">The least of these.</param>
    public void Stand(ReadOnlySpan<Vector3> points, ReadOnlySpan<float> heights, float lowest)
    {
        float min = float.MaxValue;
        for (int i = 0; i < points.Length; i++)
        {
            bool touches = heights[i] <= Math.Max(lowest, 0f) + touch;
            if (stands && touches && touched[i])
            {
                Vector3 moved = points[i] - last[i];
                min = Math.Min(min, Vec.Length(new Vector3(moved.X, 0f, moved.Z)));
            }

            last[i] = points[i];
            touched[i] = touches;
        }

        way += min < float.MaxValue ? min : 0f;
        stands = true;
        updates++;
    }

    /// <summary>The end of a stance, if there was one.</summary>
    /// <returns>How far the foot slipped in it, metres; null where it was not seen to stand.</returns>
    public float? Lift()
    {
        float? slip = updates > 1 ? way : null;
        stands = false;
        updates = 0;
        way = 0f;
        return slip;
    }
}
