using System;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>
/// How a foot out to the side goes past its hip that comes near to it or under it: on the outer side, on a parabola that begins ahead of where it is nearest and ends behind that.
/// Straight on, or along a circle, the direction from hip to foot would whirl.
/// </summary>
internal static class PastHip
{
    /// <summary>How far out from its hip the foot is at least.</summary>
    /// <param name="outward">How far out it is asked to be.</param>
    /// <param name="along">How far ahead of its hip it is, or behind that.</param>
    /// <param name="nearest">How far out it is at least right beside its hip, above 0.</param>
    public static float Out(float outward, float along, float nearest) => Math.Max(outward, nearest - (along * along / (2f * nearest)));
}
