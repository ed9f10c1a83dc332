using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Ground that is under water up to a plane: a lake, a sea, a flooded room. The bed must stand still.</summary>
public sealed class WaterGround : IWaterGround
{
    private readonly IGround bed;
    private readonly Vector3 point;
    private readonly Vector3 up;

    /// <summary>Water over a bed.</summary>
    /// <param name="bed">What is under the water, and beside it.</param>
    /// <param name="point">A point of the surface, world space, metres.</param>
    /// <param name="up">Out of the water; any length but 0.</param>
    /// <exception cref="ArgumentNullException">There is no bed.</exception>
    /// <exception cref="ArgumentException">A number is not finite, or up has no direction.</exception>
    public WaterGround(IGround bed, Vector3 point, Vector3 up)
    {
        this.bed = bed ?? throw new ArgumentNullException(nameof(bed));
        Finite.Require(point, nameof(point));
        Finite.Require(up, nameof(up));
        if (!(Vec.Length(up) > Tolerance.DirectionLength))
        {
            throw new ArgumentException("up has no length; expected a direction out of the water", nameof(up));
        }

        this.point = point;
        this.up = Vec.Normalize(up);
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit) => bed.Cast(origin, direction, distance, out hit);

    /// <inheritdoc/>
    public float DepthAt(Vector3 place) => Vec.Dot(point - place, up);
}
