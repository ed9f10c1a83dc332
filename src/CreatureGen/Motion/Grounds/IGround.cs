using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>The ground as creatures feel it: by rays. A game hands in its own physics; the library brings a plane, a height field and a triangle mesh.</summary>
public interface IGround
{
    /// <summary>The first hit along a ray. A ray that begins in solid ground is at once at its surface. There is no hit for numbers that are not finite.</summary>
    /// <param name="origin">World space, metres.</param>
    /// <param name="direction">Unit.</param>
    /// <param name="distance">How far the ray goes, metres.</param>
    /// <param name="hit">The hit; only of use when there is one.</param>
    /// <returns>Whether there is a hit.</returns>
    bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit);
}

/// <summary>Ground that is one plane wherever a ray meets it: a promise by which feet need not feel the ground around the place where they come down. What a creature does on it is the same without the promise, and takes longer.</summary>
public interface IPlaneGround : IGround
{
    /// <summary>Out of the ground, unit, world space.</summary>
    Vector3 Normal { get; }
}

/// <summary>Ground with parts that move: lifts, ships, other creatures' backs. Feet stay on the part that they stand on, and the creature is carried along.</summary>
public interface IMovingGround : IGround
{
    /// <summary>Where a moving part is now.</summary>
    /// <param name="platform">Its number, from <see cref="GroundHit.Platform"/>; not 0.</param>
    /// <param name="placement">Its place; any fixed point and axes of it will do.</param>
    /// <returns>Whether there still is such a part.</returns>
    bool TryLocate(int platform, out RootPlace placement);
}
