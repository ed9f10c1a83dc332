using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Ragdolls;

/// <summary>Ground that is one plane everywhere.</summary>
public readonly struct PlaneGround : IRagdollGround
{
    private readonly Vector3 point;
    private readonly Vector3 normal;

    /// <summary>Takes a plane.</summary>
    /// <param name="point">On the plane, world space, metres.</param>
    /// <param name="normal">Out of the ground, any length but none.</param>
    /// <exception cref="System.ArgumentException">A number is not finite.</exception>
    public PlaneGround(Vector3 point, Vector3 normal)
    {
        Finite.Require(point, nameof(point));
        Finite.Require(normal, nameof(normal));
        this.point = point;
        this.normal = Vec.Normalize(normal, Vector3.UnitY);
    }

    /// <summary>The plane y = 0.</summary>
    public static PlaneGround Level { get; } = new(Vector3.Zero, Vector3.UnitY);

    /// <inheritdoc/>
    public bool TryFind(Vector3 point, out Vector3 onGround, out Vector3 normal)
    {
        onGround = this.point;
        normal = this.normal;
        return true;
    }
}
