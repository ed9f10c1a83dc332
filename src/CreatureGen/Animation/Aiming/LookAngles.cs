using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Aiming;

/// <summary>A direction as two angles: round to the left and up, radians, seen from something that faces +Z with +Y up.</summary>
/// <param name="Yaw">To the left (towards +X) of straight ahead, −π..π.</param>
/// <param name="Pitch">Up from the horizontal, −π/2..π/2.</param>
public readonly record struct LookAngles(float Yaw, float Pitch)
{
    /// <summary>Both angles' directions and their opposites make one turn: pitch first, then yaw. It never rolls.</summary>
    public Quaternion Turn()
    {
        PortableMath.SinCos(0.5 * Yaw, out double sy, out double cy);
        PortableMath.SinCos(-0.5 * Pitch, out double sp, out double cp);
        return new Quaternion((float)(cy * sp), (float)(sy * cp), (float)(-sy * sp), (float)(cy * cp));
    }

    /// <summary>The angles of a direction of any length; straight up and down have the yaw given.</summary>
    /// <param name="direction">Not zero.</param>
    /// <param name="yawAtPole">Taken within 3° of straight up or down, where the yaw is in the noise.</param>
    public static LookAngles Of(Vector3 direction, float yawAtPole)
    {
        double across = Math.Sqrt(((double)direction.X * direction.X) + ((double)direction.Z * direction.Z));
        double pitch = PortableMath.Atan2(direction.Y, across);
        bool pole = across < 0.05 * Math.Abs((double)direction.Y) || across == 0;
        return new LookAngles(pole ? yawAtPole : (float)PortableMath.Atan2(direction.X, direction.Z), (float)pitch);
    }
}
