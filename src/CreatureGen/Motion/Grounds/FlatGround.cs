using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Grounds;

namespace CreatureGen.Motion;

/// <summary>An endless plane, solid below.</summary>
public sealed class FlatGround : IPlaneGround, ITrustedGround
{
    private readonly Vector3 point;
    private readonly Vector3 normal;
    private readonly int surface;

    /// <summary>A plane through a point.</summary>
    /// <param name="point">World space, metres.</param>
    /// <param name="normal">Out of the ground; any length but 0.</param>
    /// <param name="surface">What it is made of.</param>
    /// <exception cref="ArgumentException">A number is not finite, or the normal has no direction.</exception>
    public FlatGround(Vector3 point, Vector3 normal, int surface = 0)
    {
        Finite.Require(point, nameof(point));
        Finite.Require(normal, nameof(normal));
        if (!(Vec.Length(normal) > Tolerance.DirectionLength))
        {
            throw new ArgumentException("the normal has no length; expected a direction out of the ground", nameof(normal));
        }

        this.point = point;
        this.normal = Vec.Normalize(normal);
        this.surface = surface;
    }

    /// <summary>The plane y = 0.</summary>
    public static FlatGround Level { get; } = new(Vector3.Zero, Vector3.UnitY);

    /// <inheritdoc/>
    public Vector3 Normal => normal;

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (!(Finite.Is(origin) && Finite.Is(direction) && distance >= 0f))
        {
            return false;
        }

        float height = Vec.Dot(origin - point, normal);
        float fall = -Vec.Dot(direction, normal);

        // A ray that begins in the ground is at once at its surface.
        if (height > 0f && !(fall * distance >= height))
        {
            return false;
        }

        Vector3 at = height > 0f ? origin + (direction * (height / fall)) : origin - (normal * height);
        hit = new GroundHit(at, normal, surface);
        return true;
    }
}
