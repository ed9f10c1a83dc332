using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation;

/// <summary>A place and an orientation in the world.</summary>
/// <param name="Position">World space, metres.</param>
/// <param name="Rotation">Unit; from the thing's own axes to the world's.</param>
public readonly record struct Placement(Vector3 Position, Quaternion Rotation)
{
    /// <summary>At the origin, unturned.</summary>
    public static Placement Identity { get; } = new(Vector3.Zero, Quaternion.Identity);

    /// <summary>A point of the thing, in the world.</summary>
    public Vector3 ToWorld(Vector3 point) => Position + Maths.Rotation.Rotate(Rotation, point);

    /// <summary>A point of the world, in the thing's own axes.</summary>
    public Vector3 ToModel(Vector3 point) => Maths.Rotation.Rotate(Maths.Rotation.Inverse(Rotation), point - Position);
}
