using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Falling;

/// <summary>What the feet of a falling creature reach for: the ground near the height of its feet, as an edge behind it, and else a plane that falls along with it.</summary>
internal sealed class FallingFloor : IGround
{
    private Vector3 point;
    private Vector3 up = Vector3.UnitY;
    private IGround? ground;
    private float above;
    private float below;
    private bool endless = true;

    /// <summary>Lays the plane alone, with nothing near it.</summary>
    /// <param name="place">A point of it.</param>
    /// <param name="normal">Unit, away from the ground.</param>
    public void Lay(Vector3 place, Vector3 normal)
    {
        point = place;
        up = normal;
        ground = null;
        endless = true;
    }

    /// <summary>Lays the plane, and on it the ground that rises above it.</summary>
    /// <param name="place">A point of it.</param>
    /// <param name="normal">Unit, away from the ground.</param>
    /// <param name="real">The ground that is there.</param>
    /// <param name="highest">How far above the plane that counts, metres.</param>
    public void Lay(Vector3 place, Vector3 normal, IGround real, float highest)
    {
        Meet(place, normal, real, highest);
        below = 0f;
        endless = true;
    }

    /// <summary>Lays nothing but the ground that is there: who lands stands on it.</summary>
    /// <param name="place">Where it meets the ground.</param>
    /// <param name="normal">Unit, away from the ground.</param>
    /// <param name="real">The ground.</param>
    /// <param name="step">How far above and below the place it counts, metres.</param>
    public void Meet(Vector3 place, Vector3 normal, IGround real, float step)
    {
        above = step;
        below = step;
        endless = false;
        point = place;
        up = normal;
        ground = real;
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        float height = Vec.Dot(origin - point, up);
        if (ground != null && ground.Cast(origin, direction, distance, out hit))
        {
            float rise = Vec.Dot(hit.Point - point, up);
            if (rise > -below && rise < above)
            {
                return true;
            }
        }

        float fall = -Vec.Dot(direction, up);
        hit = new GroundHit(height > 0f && fall > 0f ? origin + (direction * (height / fall)) : origin - (up * height), up);
        return endless && (!(height > 0f) || fall * distance >= height);
    }
}
