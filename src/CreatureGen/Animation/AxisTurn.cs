using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation;

/// <summary>Turns about the axes of the model, radians: +X is the creature's left, +Y up, +Z ahead.</summary>
internal static class AxisTurn
{
    /// <summary>About X. Positive tips the front down, and swings what hangs backward.</summary>
    public static Quaternion Pitch(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion((float)sine, 0f, 0f, (float)cosine);
    }

    /// <summary>About Y. Positive turns the front to the left, and sweeps what lies out to the left backward.</summary>
    public static Quaternion Yaw(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion(0f, (float)sine, 0f, (float)cosine);
    }

    /// <summary>About Z. Positive raises the left side.</summary>
    public static Quaternion Roll(double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion(0f, 0f, (float)sine, (float)cosine);
    }

    /// <summary>First about Z, then about X, then about Y.</summary>
    public static Quaternion YawPitchRoll(float yaw, float pitch, float roll)
    {
        PortableMath.SinCos(0.5 * yaw, out double sy, out double cy);
        PortableMath.SinCos(0.5 * pitch, out double sx, out double cx);
        PortableMath.SinCos(0.5 * roll, out double sz, out double cz);
        return new Quaternion(
            (float)((cy * sx * cz) + (sy * cx * sz)),
            (float)((sy * cx * cz) - (cy * sx * sz)),
            (float)((cy * cx * sz) - (sy * sx * cz)),
            (float)((cy * cx * cz) + (sy * sx * sz)));
    }
}
