using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Turns that point one joint at something. Closed form; nothing is allocated.</summary>
public static class AimAt
{
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
        float length = Vec.Length(direction);
        return length > Tolerance.DirectionLength
            ? UnitRotation.Frame(Rotation.Rotate(rotation, forward), Rotation.Rotate(rotation, up), direction / length, upModel)
            : Quaternion.Identity;
    }
}
