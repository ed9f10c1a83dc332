using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation;

/// <summary>Turns about the axes of the model. X: a positive turn tips a snout down and swings a hanging leg back; Y: to the left; Z: left side up.</summary>
internal static class AxisTurn
{
    public static Quaternion X(float angle)
    {
        PortableMath.SinCos(0.5 * angle, out double s, out double c);
        return new Quaternion((float)s, 0f, 0f, (float)c);
    }

    public static Quaternion Y(float angle)
    {
        PortableMath.SinCos(0.5 * angle, out double s, out double c);
        return new Quaternion(0f, (float)s, 0f, (float)c);
    }

    public static Quaternion Z(float angle)
    {
        PortableMath.SinCos(0.5 * angle, out double s, out double c);
        return new Quaternion(0f, 0f, (float)s, (float)c);
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
