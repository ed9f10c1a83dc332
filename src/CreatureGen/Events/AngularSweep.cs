using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>
/// Looks at how a limb sweeps instead of at how fast its turning changes: the moments are those at which the line from a joint to the end of its limb, after going the other way, has come to sweep towards a direction. Data.
/// </summary>
/// <remarks>
/// The sweep is d/dt (u · <see cref="Towards"/>), with u the way from the joint to the end of its limb in model space in parts of its length at rest: radians per second of a limb that keeps its length and lies across. A leg swings forward, turns back, and is carried back evenly by the body as long as its
/// foot rests on the ground: touch-down is where it has reached that even speed. A stretch of sweeping belongs to a stroke, which begins when the limb has gone the other way fast enough; of each stroke the beginning of
/// its first long stretch is the moment, so that limbs that waver while they rest are told once.
/// </remarks>
public sealed record AngularSweep
{
    private AngularSweep()
    {
    }

    /// <summary>Looks at how fast the end of the line goes, whichever way. Its moments are those at which it is fastest, told by the same thresholds, gaps and intervals as those of accelerations, but in degrees per second: a tail beats to one side and to the other, a limb cuts through the air.</summary>
    public static AngularSweep AnyWay { get; } = new();

    /// <summary>As <see cref="AnyWay"/>, but how fast the end goes is told about where its line begins and through the model's space, and the slower counts: a foot on the ground rests however the trunk turns over it, and a tail that is only carried along does not beat.</summary>
    public static AngularSweep ThroughAir { get; } = new() { IsThroughAir = true };

    /// <summary>Sets the direction that is swept to.</summary>
    /// <param name="towards">In model space, any length but none: (0, 0, −1) is back.</param>
    /// <exception cref="ArgumentException">It is not finite or has no length.</exception>
    public AngularSweep(Vector3 towards)
    {
        Finite.Require(towards, nameof(towards));
        Towards = Vec.LengthSquared(towards) > 0f ? Vec.Normalize(towards, Vector3.UnitY) : throw new ArgumentException("a direction without length; expected one in model space", nameof(towards));
    }

    /// <summary>Unit direction in model space; of no length for any way.</summary>
    public Vector3 Towards { get; }

    /// <summary>What ends the line, the first of these that a joint has below it; the end of the joint's own bone where there is none. The moments are told of that joint. <see cref="JointRole.End"/> means the end of the chain of joints that have one role, such as a tail, of which then only the first has a line.</summary>
    public IReadOnlyList<JointRole> Ends { get; init; } = Array.Empty<JointRole>();

    /// <summary>Part of the usual speed of a sweep, the median of all, at which it has begun, 0 to 1.</summary>
    public float BeginsAt { get; init; } = 0.55f;

    /// <summary>Part of the greatest speed the other way that begins a new stroke, 0 to 1.</summary>
    public float ReturnsAt { get; init; } = 0.4f;

    /// <summary>Part of the farthest sweep below which a stroke is none, and of the longest stretch of a stroke below which a stretch is not its beginning, 0 to 1. Live streams, which do not know what is to come, do without.</summary>
    public float MinPart { get; init; } = 0.55f;

    /// <summary>Limbs whose end is higher at rest than this part of the skeleton's height above its lowest joint are left out, 0 to 1; 1 takes all. Hands of a standing figure are no feet.</summary>
    public float LowestPart { get; init; } = 1f;

    /// <summary>Whether all ways count.</summary>
    internal bool IsAnyWay => Towards == Vector3.Zero;

    /// <summary>Whether what rests in the model's space counts as resting.</summary>
    private bool IsThroughAir { get; init; }

    /// <summary>Speed of a line, radians per second; below 0 where it goes the other way.</summary>
    /// <param name="from">Where it ends, lengths.</param>
    /// <param name="to">The same later.</param>
    /// <param name="rate">How much later, as a rate.</param>
    internal float Speed(in SweepEnd from, in SweepEnd to, float rate)
    {
        if (!IsAnyWay)
        {
            return Vec.Dot(to.About - from.About, Towards) * rate;
        }

        float about = Vec.Distance(from.About, to.About);
        return (IsThroughAir ? Math.Min(about, Vec.Distance(from.Through, to.Through)) : about) * rate;
    }

    /// <summary>Throws unless all numbers are within their ranges.</summary>
    internal void Require(string rule)
    {
        if (!(BeginsAt >= 0f && BeginsAt <= 1f) || !(ReturnsAt >= 0f && ReturnsAt <= 1f) || !(MinPart >= 0f && MinPart <= 1f) || !(LowestPart >= 0f && LowestPart <= 1f))
        {
            throw new ArgumentException(FormattableString.Invariant($"rule {rule}: sweeps begin at {BeginsAt}, return at {ReturnsAt}, the least part is {MinPart}, the lowest {LowestPart}; expected fractions of 0 to 1"));
        }
    }
}
