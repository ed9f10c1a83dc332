using System;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>How a slope shifts the places where feet belong under a body.</summary>
internal static class SlopeShift
{
    /// <summary>How far feet are set ahead of the hips on a way uphill, and back downhill: part of what the ground rises over the height of the hip. 1 is where a trunk that lies along the slope has them.</summary>
    private const float SlopeBias = 0.6f;

    /// <summary>The same of legs out to the side, which carry the body low.</summary>
    private const float LateralSlopeBias = 1f;

    /// <summary>How far ahead of its place on the level a foot belongs on a slope, metres: so much for its hip, and nearer to the middle, as the trunk is seen from above; none on two legs, whose trunk stays upright.</summary>
    /// <param name="leg">Gives the hip.</param>
    /// <param name="rows">Number of pairs.</param>
    /// <param name="place">Ahead of the root, on the level, metres.</param>
    /// <param name="slope">Rise of the ground along the way.</param>
    public static float Ahead(LegRig leg, int rows, float place, float slope) =>
        rows == 1 ? 0f : ((leg.Lateral ? LateralSlopeBias : SlopeBias) * leg.HipRest.Y * slope) - (place * Shortening(slope));

    /// <summary>By what part a way along a slope is shorter, seen from above.</summary>
    public static float Shortening(float slope) => 1f - (1f / (float)Math.Sqrt(1f + (slope * slope)));
}
