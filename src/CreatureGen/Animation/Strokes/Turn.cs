using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Strokes;

/// <summary>Turns about the axes of the model, radians: +X is the creature's left, +Y up, +Z ahead.</summary>
internal static class Turn
{
    /// <summary>Positive tips the front down, and swings what hangs backward.</summary>
    public static Quaternion Pitch(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion((float)sine, 0f, 0f, (float)cosine);
    }

    /// <summary>Positive turns the front to the left, and sweeps what lies out to the left backward.</summary>
    public static Quaternion Yaw(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion(0f, (float)sine, 0f, (float)cosine);
    }

    /// <summary>Positive raises the left side.</summary>
    public static Quaternion Roll(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion(0f, 0f, (float)sine, (float)cosine);
    }
}
