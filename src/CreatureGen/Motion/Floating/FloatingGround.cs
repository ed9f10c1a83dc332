using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Floating;

/// <summary>Ground as feet feel it that do not reach the bed of deep water: there it is a little deeper than where the body floats.</summary>
internal sealed class FloatingGround : IMovingGround, IWaterGround
{
    private IWaterGround ground = null!;
    private Vector3 up;
    private float depth;

    /// <summary>Lays it.</summary>
    /// <param name="real">The ground and its water.</param>
    /// <param name="upward">Unit, away from the ground.</param>
    /// <param name="deepest">How deep water is that feet still feel the bed of, metres.</param>
    public void Lay(IWaterGround real, Vector3 upward, float deepest)
    {
        ground = real;
        up = upward;
        depth = deepest;
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        bool found = ground.Cast(origin, direction, distance, out hit);
        float below = found ? ground.DepthAt(hit.Point) - depth : 0f;
        if (below > 0f)
        {
            hit = new GroundHit(hit.Point + (up * below), up);
            return true;
        }

        float fall = -Vec.Dot(direction, up);
        if (found || !(fall > 0.5f))
        {
            return found;
        }

        // Water without a bed.
        float above = depth - ground.DepthAt(origin);
        if (!(above <= fall * distance))
        {
            return false;
        }

        hit = new GroundHit(origin + (direction * (above / fall)), up);
        return true;
    }

    /// <inheritdoc/>
    public float DepthAt(Vector3 place) => ground.DepthAt(place);

    /// <inheritdoc/>
    public bool TryLocate(int platform, out RootPlace placement)
    {
        if (ground is IMovingGround moving)
        {
            return moving.TryLocate(platform, out placement);
        }

        placement = RootPlace.Identity;
        return false;
    }
}
