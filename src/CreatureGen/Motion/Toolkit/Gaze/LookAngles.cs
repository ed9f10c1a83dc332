using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A direction as two angles: round to the left and up, radians, seen from something that faces +Z with +Y up.</summary>
/// <param name="Yaw">To the left (towards +X) of straight ahead, −π..π.</param>
/// <param name="Pitch">Up from the horizontal, −π/2..π/2.</param>
public readonly record struct LookAngles(float Yaw, float Pitch)
{
    /// <summary>Both angles' directions and their opposites make one turn: pitch first, then yaw. It never rolls.</summary>
    public Quaternion Turn()
    {
        FastTrigonometry.SinCos(0.5f * Yaw, out float sy, out float cy);
        FastTrigonometry.SinCos(-0.5f * Pitch, out float sp, out float cp);
        return new Quaternion(cy * sp, sy * cp, -sy * sp, cy * cp);
    }

    /// <summary>The angles of a direction of any length; straight up and down have the yaw given.</summary>
    /// <param name="direction">Not zero.</param>
    /// <param name="yawAtPole">Taken within 3° of straight up or down, where the yaw is in the noise.</param>
    public static LookAngles Of(Vector3 direction, float yawAtPole)
    {
        double across = Math.Sqrt(((double)direction.X * direction.X) + ((double)direction.Z * direction.Z));
        bool pole = across < 0.05 * Math.Abs((double)direction.Y) || across == 0;
        return new LookAngles(pole ? yawAtPole : FastTrigonometry.Of(direction.X, direction.Z), FastTrigonometry.Of(direction.Y, (float)across));
    }
}
