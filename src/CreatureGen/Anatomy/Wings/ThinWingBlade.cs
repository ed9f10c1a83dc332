using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Wings;

/// <summary>How the blade of a thin wing lies about its axis.</summary>
internal static class ThinWingBlade
{
    /// <summary>Rise of the rear edge of a spread wing at rest and as it flies, for each 1 that it goes back: at rest it is raised so far that the wing is no line from the front or from behind, nor the near one in three-quarter view.</summary>
    private const float RestRise = 0.85f;
    private const float FlownRise = 0.22f;

    /// <summary>The same of a wing that is laid back over the body: towards the midline and down.</summary>
    private const float LaidRise = -0.28f;

    /// <summary>Direction in which the blade of a left wing goes back from its axis at rest, unit.</summary>
    /// <param name="along">The axis, from root to tip, unit.</param>
    public static Vector3 Trailing(Vector3 along)
    {
        double azimuth = PortableMath.Atan2(along.Z, along.X);
        float laid = Scalar.Smooth(((float)-azimuth - 0.6f) / 0.5f);
        return Trailing(along, azimuth, Scalar.Lerp(RestRise, LaidRise, laid));
    }

    /// <summary>By how much the rear edge of a left wing is raised higher at rest than it is in flight, about the axis, radians.</summary>
    /// <param name="along">The axis, from root to tip, unit.</param>
    public static double RestIncidence(Vector3 along)
    {
        double azimuth = PortableMath.Atan2(along.Z, along.X);
        float laid = Scalar.Smooth(((float)-azimuth - 0.6f) / 0.5f);
        Vector3 flown = Trailing(along, azimuth, Scalar.Lerp(FlownRise, LaidRise, laid));
        Vector3 rest = Trailing(along);
        return PortableMath.Atan2(Vec.Dot(Vec.Cross(flown, rest), along), Vec.Dot(flown, rest));
    }

    private static Vector3 Trailing(Vector3 along, double azimuth, float rise)
    {
        var back = new Vector3((float)PortableMath.Sin(azimuth), rise, -(float)PortableMath.Cos(azimuth));
        return Vec.Normalize(Vec.Reject(back, along), Vector3.UnitZ);
    }
}
