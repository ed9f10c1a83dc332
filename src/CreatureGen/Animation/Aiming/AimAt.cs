using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Aiming;

/// <summary>Turns that point one joint at something. Closed form; nothing is allocated.</summary>
public static class AimAt
{
    // Sine below which "up" is in line with the aim and gives no roll.
    private const float LeastSine = 1e-4f;

    /// <summary>The turn in model space that points a joint's axis along a direction, and rolls it so that its upward axis is as near as it can be to a given one.</summary>
    /// <param name="rotation">The joint's model rotation; the result times this is its new one.</param>
    /// <param name="forward">The axis to point, unit, in the joint's own space.</param>
    /// <param name="up">The axis to keep up, unit, in the joint's own space, not along <paramref name="forward"/>.</param>
    /// <param name="direction">Where to point, model space, any length; none changes nothing.</param>
    /// <param name="upModel">Where up is, model space, any length. In line with the direction it says nothing, and the turn is the smallest there is.</param>
    /// <exception cref="System.ArgumentException">A direction is not finite.</exception>
    public static Quaternion Turn(Quaternion rotation, Vector3 forward, Vector3 up, Vector3 direction, Vector3 upModel)
    {
        Finite.Require(direction, nameof(direction));
        Finite.Require(upModel, nameof(upModel));
        Vector3 from = Rotation.Rotate(rotation, forward);
        Quaternion aim = Rotation.FromTo(from, direction);
        Vector3 to = Rotation.Rotate(aim, from);
        Vector3 now = Vec.Reject(Rotation.Rotate(aim, Rotation.Rotate(rotation, up)), to);
        Vector3 wanted = Vec.Reject(upModel, to);
        if (Vec.LengthSquared(wanted) <= LeastSine * LeastSine * Vec.LengthSquared(upModel) || Vec.LengthSquared(now) <= LeastSine * LeastSine)
        {
            return aim;
        }

        // Both lie across the aim, so the roll is about it and cannot tilt it, however far it goes.
        double product = System.Math.Sqrt((double)Vec.LengthSquared(now) * Vec.LengthSquared(wanted));
        HalfAngle.Of(Vec.Dot(now, wanted) / product, Vec.Dot(Vec.Cross(now, wanted), to) / product, out double c, out double s);
        var roll = new Quaternion((float)(to.X * s), (float)(to.Y * s), (float)(to.Z * s), (float)c);
        return Rotation.Normalize(Rotation.Multiply(roll, aim));
    }
}
