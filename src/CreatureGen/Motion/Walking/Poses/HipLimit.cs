using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>
/// How a leg bends whose hip is at its limit, by how far its foot is in its step: a mixture of the leg as it stands, whose foot comes as near to its place as it can, and of the leg in the air, whose foot keeps out of the ground.
/// One that is about to come down is taken for what it will be as it stands.
/// </summary>
internal readonly struct HipLimit
{
    /// <summary>How far hip and knee of a standing leg may be beyond their limits, half the angle in radians: a tenth of a degree, so that rounding does not move the foot.</summary>
    private const float StandingTolerance = 0.0008f;

    /// <summary>Part of a swing in which a foot comes off the edge of the sole that it stood on.</summary>
    private const float Release = 0.35f;

    /// <summary>Part of a swing from which on a foot turns onto the edge of the sole that it will stand on.</summary>
    private const float Arrival = 0.85f;

    private readonly bool raised;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private HipLimit(bool raised, float standing, float arriving, float slack, float tolerance)
    {
        this.raised = raised;
        Standing = standing;
        Arriving = arriving;
        Slack = slack;
        Tolerance = tolerance;
    }

    /// <summary>How much the leg is still as it stood, 0..1.</summary>
    public float Standing { get; }

    /// <summary>How far the foot is about to come down, 0..1.</summary>
    public float Arriving { get; }

    /// <summary>How much the leg is as it stood or as it will stand, 0..1.</summary>
    public float Held => Math.Max(Standing, Arriving);

    /// <summary>How far the knee has to stay from straight, 0..1.</summary>
    public float Slack { get; }

    /// <summary>How far hip and knee may be beyond their limits, half the angle in radians.</summary>
    public float Tolerance { get; }

    /// <summary>That of a foot.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static HipLimit Of(in Foot foot) => foot.Phase == FootPhase.Swing
        ? new HipLimit(true, 1f - Scalar.Smooth(foot.Swing / Release), Scalar.Smooth((foot.Swing - Arrival) / (1f - Arrival)), LegGaitParameters.SlackCurve.At(foot.Swing), 0f)
        : new HipLimit(false, 1f, 0f, 0f, StandingTolerance);

    /// <summary>Bends the knee. The foot keeps its own turn.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="parts">Its two solved parts.</param>
    /// <param name="goal">What it reaches for.</param>
    /// <param name="away">Direction away from the way of its foot.</param>
    /// <param name="way">How far along it that way is from the hip, metres of the model.</param>
    /// <param name="solved">The leg as its hip lets it be.</param>
    public void Bend(LegRig leg, in LegSegments parts, in LegGoal goal, Vector3 away, float way, ref LegRotations solved)
    {
        LegRotations stood = solved;
        if (Standing > 0f)
        {
            LegSolver.Bend(leg, parts, goal.Chord, Tolerance, ref stood);
        }

        if (!raised)
        {
            solved = stood;
            return;
        }

        LegSolver.Raise(leg, parts, away, way, Tolerance, ref solved);
        if (Standing > 0f)
        {
            solved.Blend(stood, Standing, leg.Hinge);
        }
    }

    /// <summary>How far toes lie as they should where the ankle turns their foot, 0..1: those of flat feet do on the ground, those of legs out to the side less and less before and after.</summary>
    /// <param name="leg">Whose.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Laid(LegRig leg) => !leg.FlatFoot ? 0f : leg.Lateral ? Held : 1f;

    /// <summary>Part of its place on an edge of its sole that a foot takes: all of it on the ground, less and less before and after, and, under its body, no more of it in the air than it had on the ground and none where an act holds it.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="foot">Its foot.</param>
    /// <param name="excess">How far its joints keep it from lying on the ground as it should, about half the angle in radians.</param>
    public float Relaxed(LegRig leg, in Foot foot, float excess)
    {
        if (leg.Lateral)
        {
            return Held;
        }

        return raised ? Math.Max(Arriving, Math.Min(foot.Leg.Relaxation / excess, 1f) * Standing) : 1f - foot.Path.Aloft;
    }
}
