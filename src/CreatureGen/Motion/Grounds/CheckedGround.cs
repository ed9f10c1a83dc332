using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Grounds;

/// <summary>
/// The one gate through which a game's ground comes in. A hit that is no hit counts as none: one with numbers that are not finite, with a normal that is not unit, or farther away than any ground could be.
/// </summary>
internal class CheckedGround : IWaterGround
{
    /// <summary>A hit may be farther from where the ray begins than the ray is long, as the ray may begin deep in the ground; farther than that many lengths of the ray, and than a kilometre, it is an error.</summary>
    private const float FarthestLengths = 100f;
    private const float FarthestMetres = 1000f;

    private IGround ground = FlatGround.Level;
    private IWaterGround? water;

    /// <summary>Whether the ground of this update may throw: any but the library's own.</summary>
    public bool MayThrow { get; private set; }

    /// <summary>Hits that counted as none since the beginning of the update.</summary>
    public int Refused { get; protected set; }

    /// <summary>Begins an update over a ground.</summary>
    public void Begin(IGround given)
    {
        ground = given;
        water = given as IWaterGround;
        MayThrow = given is not ITrustedGround;
        Refused = 0;
    }

    /// <summary>Begins an update over the ground of the last one.</summary>
    public void BeginAgain() => Refused = 0;

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        if (ground.Cast(origin, direction, distance, out hit))
        {
            if (IsSound(hit, origin, distance))
            {
                return true;
            }

            Refused++;
        }

        hit = default;
        return false;
    }

    /// <inheritdoc/>
    public float DepthAt(Vector3 place)
    {
        float depth = water?.DepthAt(place) ?? float.NegativeInfinity;
        return Math.Abs(depth) <= RootPlace.Farthest ? depth : float.NegativeInfinity;
    }

    /// <summary>Whether a hit can be one.</summary>
    public static bool IsSound(in GroundHit hit, Vector3 origin, float distance)
    {
        float farthest = Math.Max(FarthestMetres, FarthestLengths * distance);
        return Math.Abs(Vec.LengthSquared(hit.Normal) - 1f) <= 2f * Tolerance.UnitLength && Vec.LengthSquared(hit.Point - origin) <= farthest * farthest;
    }
}

/// <summary>The gate for ground with parts that move.</summary>
internal sealed class CheckedMovingGround : CheckedGround, IMovingGround
{
    private IMovingGround? moving;

    /// <summary>Begins an update over a ground.</summary>
    public void Begin(IMovingGround given)
    {
        base.Begin(given);
        moving = given;
    }

    /// <inheritdoc/>
    public bool TryLocate(int platform, out RootPlace placement)
    {
        if (moving!.TryLocate(platform, out placement))
        {
            if (placement.IsMade)
            {
                return true;
            }

            Refused++;
        }

        placement = RootPlace.Identity;
        return false;
    }
}

/// <summary>The gate for ground that promises to be one plane: the promise goes through with it.</summary>
internal sealed class CheckedPlaneGround : CheckedGround, IPlaneGround
{
    private IPlaneGround plane = FlatGround.Level;

    /// <inheritdoc/>
    public Vector3 Normal => plane.Normal;

    /// <summary>Begins an update over a ground.</summary>
    public void Begin(IPlaneGround given)
    {
        base.Begin(given);
        plane = given;
    }
}
