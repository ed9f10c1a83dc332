using System;
using System.Numerics;
using System.Runtime.ExceptionServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Grounds;

/// <summary>
/// The one gate through which a game's ground comes in. A hit that is no hit counts as none: one with numbers that are not finite, with a normal that is not unit, or farther away than any ground could be.
/// A ground that throws is no ground for the rest of the update; what it threw is thrown on when the update is complete, so that the creature is never left half way.
/// </summary>
internal class CheckedGround : IGround
{
    /// <summary>A hit may be farther from where the ray begins than the ray is long, as the ray may begin deep in the ground; farther than that many lengths of the ray, and than a kilometre, it is an error.</summary>
    private const float FarthestLengths = 100f;
    private const float FarthestMetres = 1000f;

    private IGround ground = FlatGround.Level;
    private ExceptionDispatchInfo? failure;

    /// <summary>Hits that counted as none since the beginning of the update.</summary>
    public int Refused { get; protected set; }

    /// <summary>Whether the ground has thrown in this update.</summary>
    protected bool HasFailed => failure != null;

    /// <summary>Begins an update over a ground.</summary>
    public void Begin(IGround given)
    {
        ground = given;
        failure = null;
        Refused = 0;
    }

    /// <summary>Ends it.</summary>
    /// <exception cref="Exception">What the ground has thrown, as it was.</exception>
    public void End()
    {
        ExceptionDispatchInfo? thrown = failure;
        failure = null;
        thrown?.Throw();
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        try
        {
            if (failure == null && ground.Cast(origin, direction, distance, out hit))
            {
                if (IsSound(hit, origin, distance))
                {
                    return true;
                }

                Refused++;
            }
        }
        catch (Exception problem)
        {
            Fail(problem);
        }

        hit = default;
        return false;
    }

    /// <summary>Whether a hit can be one.</summary>
    public static bool IsSound(in GroundHit hit, Vector3 origin, float distance)
    {
        float farthest = Math.Max(FarthestMetres, FarthestLengths * distance);
        return Math.Abs(Vec.LengthSquared(hit.Normal) - 1f) <= 2f * Tolerance.UnitLength && Vec.LengthSquared(hit.Point - origin) <= farthest * farthest;
    }

    /// <summary>Remembers what the ground has thrown.</summary>
    protected void Fail(Exception problem) => failure = ExceptionDispatchInfo.Capture(problem);
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
        try
        {
            if (!HasFailed && moving!.TryLocate(platform, out placement))
            {
                if (placement.IsMade)
                {
                    return true;
                }

                Refused++;
            }
        }
        catch (Exception problem)
        {
            Fail(problem);
        }

        placement = RootPlace.Identity;
        return false;
    }
}
