using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Events;

/// <summary>Rotations as roll, pitch and yaw.</summary>
internal static class EulerAngles
{
    /// <summary>Pitch about X, yaw about Y, roll about Z, radians: turned first by roll, then by pitch, then by yaw.</summary>
    public static Vector3 Of(Quaternion q)
    {
        Rotation.ToBasis(q, out Vector3 x, out Vector3 y, out Vector3 z);
        double pitch = -PortableMath.Asin(Scalar.Clamp(z.Y, -1.0, 1.0));
        double yaw = PortableMath.Atan2(z.X, z.Z);
        double roll = PortableMath.Atan2(x.Y, y.Y);
        return new Vector3((float)pitch, (float)yaw, (float)roll);
    }
}
