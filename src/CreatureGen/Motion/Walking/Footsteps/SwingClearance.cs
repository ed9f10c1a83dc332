using System;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>The ground along the way of a swing: how far a foot has to rise above the straight line from where it leaves the ground to where it comes down.</summary>
/// <remarks>The rise is the least that is concave, so that a foot goes over what is in its way in one arc, and is smooth between the knots.</remarks>
internal sealed class SwingClearance
{
    /// <summary>Places along the way at which the ground is felt, the ends not counted.</summary>
    public const int Knots = 7;

    /// <summary>Rise from one knot to the next, as part of their distance, from which on it is an edge: it may be anywhere between them.</summary>
    private const float EdgeSlope = 0.6f;

    /// <summary>Slope at an end of a span, of its mean one, up to which the curve does not overshoot (Fritsch and Carlson 1980).</summary>
    private const float SteepestMonotone = 3f;

    private readonly float[] heights = new float[Knots + 2];
    private readonly float[] rise = new float[Knots + 2];
    private readonly int[] hull = new int[Knots + 2];
    private bool level = true;

    /// <summary>Share of the way at which a knot is, 0..1.</summary>
    /// <param name="knot">0..<see cref="Knots"/> − 1.</param>
    public static float At(int knot) => (knot + 1f) / (Knots + 1);

    /// <summary>The first knot beyond a share of the way; <see cref="Knots"/> for none.</summary>
    public static int After(float along) => Math.Min((int)(along * (Knots + 1)), Knots);

    /// <summary>Asks memory for whether there is anything in the way.</summary>
    /// <returns>See <see cref="Maths.MemoryLines"/>.</returns>
    public int Fetch() => level ? 1 : 0;

    /// <summary>Forgets the ground.</summary>
    public void Clear()
    {
        Array.Clear(heights, 0, heights.Length);
        Array.Clear(rise, 0, rise.Length);
        level = true;
    }

    /// <summary>Takes over what another knows.</summary>
    public void CopyFrom(SwingClearance other)
    {
        other.heights.CopyTo(heights, 0);
        other.rise.CopyTo(rise, 0);
        level = other.level;
    }

    /// <summary>Tells how far the ground is above the straight line.</summary>
    /// <param name="knot">Where.</param>
    /// <param name="height">Metres.</param>
    /// <param name="fraction">Share of the change that is taken up, 0..1.</param>
    public void Feel(int knot, float height, float fraction) => heights[knot + 1] += (height - heights[knot + 1]) * fraction;

    /// <summary>Lays the arc over what was felt.</summary>
    /// <param name="length">Of the way, metres.</param>
    /// <param name="sole">How far the sole reaches from its place, metres.</param>
    /// <param name="from">Slope of the sole along the way as it leaves the ground, less that of the way.</param>
    /// <param name="to">The same as it comes down.</param>
    public void Span(float length, float sole, float from, float to)
    {
        float spacing = length / (Knots + 1);
        float reach = Math.Min(sole, spacing) / Math.Max(spacing, 1e-6f);
        int count = 1;
        level = true;
        hull[0] = 0;
        for (int i = 1; i < rise.Length; i++)
        {
            float tilt = spacing * (from + ((to - from) * i / (Knots + 1)));
            rise[i] = i == rise.Length - 1 ? 0f : heights[i] + Math.Max(0f, Math.Max(Beside(i, i - 1, spacing, reach, -tilt), Beside(i, i + 1, spacing, reach, tilt)));
            level &= rise[i] <= 0f;
            while (count > 1 && (rise[hull[count - 1]] - rise[hull[count - 2]]) * (i - hull[count - 2]) <= (rise[i] - rise[hull[count - 2]]) * (hull[count - 1] - hull[count - 2]))
            {
                count--;
            }

            hull[count++] = i;
        }

        for (int k = 1; k < count; k++)
        {
            int a = hull[k - 1];
            int b = hull[k];
            for (int i = a + 1; i < b; i++)
            {
                rise[i] = rise[a] + ((rise[b] - rise[a]) * (i - a) / (b - a));
            }
        }
    }

    /// <summary>How far the foot has to be above the straight line, metres.</summary>
    /// <param name="along">Share of the way, 0..1.</param>
    public float Rise(float along)
    {
        if (level)
        {
            return 0f;
        }

        float x = along * (Knots + 1);
        int i = Math.Min((int)x, Knots);
        float t = x - i;

        // Hermite with slopes, in units of the knots' distance, that neither overshoot nor dip.
        float a = rise[i];
        float b = rise[i + 1];
        float from = i == 0 ? Steep(b - a) : Slope(a - rise[i - 1], b - a);
        float to = i == Knots ? -Steep(a - b) : Slope(b - a, rise[i + 2] - b);
        float u = 1f - t;
        return (a * u * u * (1f + (2f * t))) + (b * t * t * (3f - (2f * t))) + (from * t * u * u) - (to * u * t * t);
    }

    /// <summary>Slope at an end where the foot rises from the ground, or comes down to it: an edge may be right there.</summary>
    private static float Steep(float rise) => rise > 0f ? SteepestMonotone * rise : rise;

    /// <summary>Slope at a knot between two spans: their harmonic mean, none at a peak (Fritsch and Butland 1984).</summary>
    private static float Slope(float before, float after) => before * after <= 0f ? 0f : 2f * before * after / (before + after);

    /// <summary>How much higher than the sole the ground is that it may reach on the side of another knot.</summary>
    private float Beside(int knot, int other, float spacing, float reach, float tilt)
    {
        float higher = heights[other] - heights[knot];
        return higher > EdgeSlope * spacing ? higher : (higher - tilt) * reach;
    }
}
