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

    // How much farther it is raised at rest where the wing points back more than up, or the blade would lie in the line of sight from the side and be a rod; by how much more it points back where that begins and where it is all of it; and azimuths, radians, from which on and at which it points back at all.
    private const float SweptRise = 0.95f;
    private const float Swept = -0.12f;
    private const float WhollySwept = 0.02f;
    private const float Aslant = -0.1f;
    private const float WhollyAslant = -0.3f;

    // Azimuths, radians, from which on and at which a wing is laid back over the body.
    private const float Laid = -1.05f;
    private const float WhollyLaid = -1.15f;

    /// <summary>The same of a wing that is laid back over the body: towards the midline and up, as a roof; level, or down to the midline, it is a sliver from the side and from ahead.</summary>
    private const float LaidRise = 0.55f;

    /// <summary>Direction in which the blade of a left wing goes back from its axis at rest, unit.</summary>
    /// <param name="along">The axis, from root to tip, unit.</param>
    public static Vector3 Trailing(Vector3 along)
    {
        double azimuth = PortableMath.Atan2(along.Z, along.X);
        float swept = Between((float)azimuth, Aslant, WhollyAslant) * Between(-along.Z - along.Y, Swept, WhollySwept);
        return Trailing(along, azimuth, RestRise + (SweptRise * swept));
    }

    /// <summary>By how much the rear edge of a left wing is raised higher at rest than it is in flight, about the axis, radians.</summary>
    /// <param name="along">The axis, from root to tip, unit.</param>
    public static double RestIncidence(Vector3 along)
    {
        double azimuth = PortableMath.Atan2(along.Z, along.X);
        Vector3 flown = Trailing(along, azimuth, FlownRise);
        Vector3 rest = Trailing(along);
        return PortableMath.Atan2(Vec.Dot(Vec.Cross(flown, rest), along), Vec.Dot(flown, rest));
    }

    private static Vector3 Trailing(Vector3 along, double azimuth, float spread)
    {
        float rise = Scalar.Lerp(spread, LaidRise, Between((float)azimuth, Laid, WhollyLaid));
        var back = new Vector3((float)PortableMath.Sin(azimuth), rise, -(float)PortableMath.Cos(azimuth));
        return Vec.Normalize(Vec.Reject(back, along), Vector3.UnitZ);
    }

    private static float Between(float value, float first, float last) => Scalar.Smooth((value - first) / (last - first));
}
