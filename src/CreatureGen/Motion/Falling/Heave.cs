using System;

namespace CreatureGen.Motion.Falling;

/// <summary>How high a body heaves itself as it draws its legs in under it: a smooth curve that stays above what they ask for at a row of moments, instead of a jolt at each of them.</summary>
internal sealed class Heave
{
    /// <summary>Number of parts into which the time is divided.</summary>
    public const int Parts = 24;

    /// <summary>How many moments before and after its own one asks for height: as far as the curve at one depends on others.</summary>
    private const int Around = 2;

    private readonly float[] asked = new float[Parts + 1];
    private readonly float[] heights = new float[Parts + 1];

    /// <summary>Tells what a moment asks for; all have to be told before <see cref="Finish"/>.</summary>
    /// <param name="moment">0 to <see cref="Parts"/>.</param>
    /// <param name="height">Metres.</param>
    public void Ask(int moment, float height) => asked[moment] = height;

    /// <summary>Makes the curve. It begins and ends on the ground.</summary>
    public void Finish()
    {
        for (int i = 0; i <= Parts; i++)
        {
            // Close to its end it looks less far around, for it comes to rest there.
            int around = Math.Min(Around, Parts - 1 - i);
            float height = 0f;
            for (int j = Math.Max(i - around, 0); j <= i + around; j++)
            {
                height = Math.Max(height, asked[j]);
            }

            heights[i] = i is 0 or Parts ? 0f : height;
        }
    }

    /// <summary>Its height at a moment: a uniform quadratic B-spline over the moments.</summary>
    /// <param name="u">0..1.</param>
    public float At(float u)
    {
        float place = u * Parts;
        int i = Math.Min((int)(place + 0.5f), Parts);
        float t = place - i;
        float before = i == 0 ? -heights[1] : heights[i - 1];
        float after = i == Parts ? -heights[Parts - 1] : heights[i + 1];
        float rear = 0.5f - t;
        float front = 0.5f + t;
        return (0.5f * rear * rear * before) + ((0.75f - (t * t)) * heights[i]) + (0.5f * front * front * after);
    }

    /// <summary>Takes over another.</summary>
    public void CopyFrom(Heave other) => other.heights.CopyTo(heights, 0);
}
