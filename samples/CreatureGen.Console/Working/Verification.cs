using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Inspection;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Console.Working;

/// <summary>An invariant that a creature breaks.</summary>
internal sealed record VerificationProblem(LocomotionKind Kind, Specimen Specimen, string Invariant, string Detail);

/// <summary>What came of checking one creature.</summary>
/// <param name="Kind">How it moves.</param>
/// <param name="Specimen">Its seed and individual.</param>
/// <param name="Problems">What it breaks.</param>
/// <param name="Crossings">How often its surface crosses itself at rest.</param>
/// <param name="Everywhere">The same on all levels of detail and in poses; null when nobody looked.</param>
internal sealed record VerifiedCreature(LocomotionKind Kind, Specimen Specimen, IReadOnlyList<VerificationProblem> Problems, SurfaceCrossings Crossings, CrossingReport? Everywhere);

/// <summary>What came of checking many creatures.</summary>
internal sealed class Verification
{
    private readonly List<VerificationProblem> problems = [];
    private readonly List<(LocomotionKind Kind, Specimen Specimen)> crossing = [];
    private readonly List<VerifiedCreature> looked = [];
    private readonly long[] piecesByKind = new long[Enum.GetValues<LocomotionKind>().Length];
    private readonly long[] checkedByKind = new long[Enum.GetValues<LocomotionKind>().Length];
    private readonly long[] failedByKind = new long[Enum.GetValues<LocomotionKind>().Length];

    /// <summary>Creatures that were checked.</summary>
    public long Checked => checkedByKind.Sum();

    /// <summary>Creatures that break an invariant.</summary>
    public long Failed => failedByKind.Sum();

    /// <summary>Creatures whose surface crosses itself.</summary>
    public long SelfIntersecting => crossing.Count;

    /// <summary>Creatures with a piece that crosses itself.</summary>
    public long PiecesCrossing => piecesByKind.Sum();

    /// <summary>The creatures that were looked at on all levels of detail and in poses, with what was found.</summary>
    public IReadOnlyList<VerifiedCreature> Looked => looked;

    /// <summary>All that is broken, in the order of the seeds.</summary>
    public IReadOnlyList<VerificationProblem> Problems => problems;

    /// <summary>The creatures whose surface crosses itself, in the order of the seeds.</summary>
    public IReadOnlyList<(LocomotionKind Kind, Specimen Specimen)> Crossing => crossing;

    /// <summary>Creatures of a kind that were checked.</summary>
    public long CheckedOf(LocomotionKind kind) => checkedByKind[(int)kind];

    /// <summary>Creatures of a kind that break an invariant.</summary>
    public long FailedOf(LocomotionKind kind) => failedByKind[(int)kind];

    /// <summary>Creatures of a kind whose surface crosses itself.</summary>
    public long SelfIntersectingOf(LocomotionKind kind) => crossing.Count(creature => creature.Kind == kind);

    /// <summary>Creatures of a kind with a piece that crosses itself.</summary>
    public long PiecesCrossingOf(LocomotionKind kind) => piecesByKind[(int)kind];

    /// <summary>Creatures of a kind that break one invariant.</summary>
    public int FailedOf(LocomotionKind kind, string invariant) =>
        problems.Where(problem => problem.Kind == kind && problem.Invariant == invariant).Select(problem => problem.Specimen).Distinct().Count();

    /// <summary>Adds a creature.</summary>
    public void Add(VerifiedCreature creature)
    {
        int kind = (int)creature.Kind;
        checkedByKind[kind]++;
        failedByKind[kind] += creature.Problems.Count > 0 ? 1 : 0;
        piecesByKind[kind] += creature.Crossings.Pieces > 0 ? 1 : 0;
        if (creature.Everywhere != null)
        {
            looked.Add(creature);
        }

        if (creature.Crossings.Body > 0)
        {
            crossing.Add((creature.Kind, creature.Specimen));
        }

        problems.AddRange(creature.Problems);
    }
}
