using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>What came of checking many creatures, as a table: a column for each kind, a row for each invariant.</summary>
internal static class VerificationText
{
    private const int ColumnWidth = 12;

    // More can be had as JSON.
    private const int ProblemsShown = 20;

    /// <summary>Writes it.</summary>
    public static void Write(TextWriter output, Verification verification, IReadOnlyList<string> invariants, Ink ink)
    {
        LocomotionKind[] kinds = Enum.GetValues<LocomotionKind>();
        string[] rows = invariants.Concat(verification.Problems.Select(problem => problem.Invariant)).Distinct().ToArray();
        int width = rows.Append("self-intersecting").Max(row => row.Length) + 2;
        output.WriteLine(ink.Heading("".PadRight(width) + string.Concat(kinds.Select(kind => WordList<LocomotionKind>.Instance[kind].PadLeft(ColumnWidth))) + "all".PadLeft(ColumnWidth)));
        Row("checked", kinds.Select(verification.CheckedOf), verification.Checked);
        Row("failed", kinds.Select(verification.FailedOf), verification.Failed);
        Row("self-intersecting", kinds.Select(verification.SelfIntersectingOf), verification.SelfIntersecting);
        Row("pieces crossing", kinds.Select(verification.PiecesCrossingOf), verification.PiecesCrossing);
        if (verification.Looked.Count > 0)
        {
            Counts("levels crossing", creature => creature.Everywhere!.Levels.All > 0 ? 1 : 0);
            Counts("poses crossing", creature => creature.Everywhere!.CrossingPoses);
            Counts("of poses", creature => creature.Everywhere!.Poses);
        }

        output.WriteLine();
        output.WriteLine(ink.Heading("Broken invariants (creatures)"));
        foreach (string invariant in rows)
        {
            long[] broken = kinds.Select(kind => (long)verification.FailedOf(kind, invariant)).ToArray();
            Row(invariant, broken, broken.Sum());
        }

        output.WriteLine();
        foreach (VerificationProblem problem in verification.Problems.Take(ProblemsShown))
        {
            output.WriteLine($"{WordList<LocomotionKind>.Instance[problem.Kind]} {problem.Specimen.Name}: {problem.Invariant}: {problem.Detail}");
        }

        if (verification.Problems.Count > ProblemsShown)
        {
            output.WriteLine($"... and {Units.Count(verification.Problems.Count - ProblemsShown)} more; --json lists all");
        }

        if (verification.Crossing.Count > 0)
        {
            string more = verification.Crossing.Count > ProblemsShown ? ", ..." : "";
            output.WriteLine("Self-intersecting: " + string.Join(", ", verification.Crossing.Take(ProblemsShown).Select(creature => $"{WordList<LocomotionKind>.Instance[creature.Kind]} {creature.Specimen.Name}")) + more);
        }

        output.WriteLine(verification.Failed == 0
            ? ink.Good("All invariants hold.")
            : ink.Bad($"{Units.Count(verification.Failed)} of {Units.Count(verification.Checked)} creatures break an invariant."));

        void Counts(string label, Func<VerifiedCreature, long> count) =>
            Row(label, kinds.Select(kind => verification.Looked.Where(creature => creature.Kind == kind).Sum(count)), verification.Looked.Sum(count));

        void Row(string label, IEnumerable<long> counts, long all) =>
            output.WriteLine(label.PadRight(width) + string.Concat(counts.Append(all).Select(count => Units.Count(count).PadLeft(ColumnWidth))));
    }
}
