using System.Numerics;

namespace CreatureGen.Animation.Ragdolls;

/// <summary>What a ragdoll falls on. Implemented as a structure it costs no allocation and no virtual call.</summary>
public interface IRagdollGround
{
    /// <summary>The plane that stands for the ground near a point.</summary>
    /// <param name="point">World space, metres; may lie below the ground.</param>
    /// <param name="onGround">Receives a point of the plane, world space.</param>
    /// <param name="normal">Receives the unit normal of the plane, out of the ground.</param>
    /// <returns>False where there is no ground.</returns>
    bool TryFind(Vector3 point, out Vector3 onGround, out Vector3 normal);
}
