using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Modes;

/// <summary>Moves a root by velocities in its own axes.</summary>
internal static class RootStep
{
    /// <summary>Where a root is after a time.</summary>
    /// <param name="place">Before.</param>
    /// <param name="velocity">In metres of the model; the place's scale makes it larger.</param>
    /// <param name="dt">Seconds.</param>
    public static RootPlace Advance(in RootPlace place, in BodyVelocity velocity, float dt)
    {
        // Half of the turn before the way, half after: the chord of the arc.
        Quaternion half = AxisRotation.Yaw(0.5f * velocity.YawRate * dt);
        Quaternion middle = Rotation.Multiply(place.Rotation, half);
        Vector3 way = Rotation.Rotate(middle, velocity.Linear * place.Scale) * dt;
        return new RootPlace(place.Position + way, Rotation.Normalize(Rotation.Multiply(middle, half)), place.Scale);
    }

    /// <summary>What was asked of a creature that was moved so.</summary>
    public static MotionInput Asked(in RootPlace place, float dt, in RootPlace goal, MotionMedium medium)
    {
        if (dt <= 0f)
        {
            return new MotionInput(0f, Medium: medium);
        }

        Vector3 way = Rotation.Rotate(Rotation.Inverse(place.Rotation), goal.Position - place.Position) / dt;
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(place.Rotation), goal.Rotation);
        return new MotionInput(way.Z, 2f * (turn.W < 0f ? -turn.Y : turn.Y) / dt, way.X, way.Y, medium);
    }
}
