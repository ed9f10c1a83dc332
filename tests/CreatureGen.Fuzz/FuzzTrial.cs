using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Inspection;
using CreatureGen.Repairs;

namespace CreatureGen.Fuzz;

/// <summary>What came of an input.</summary>
internal enum FuzzVerdict
{
    /// <summary>The reader or the validator refused it and said why.</summary>
    Refused,

    /// <summary>The reader and the validator accept it; its creature was not built.</summary>
    Accepted,

    /// <summary>It was accepted and its creature keeps all promises.</summary>
    Sound,

    /// <summary>The validator accepted it, the inspection of the creature told what is broken; nobody tried to repair it.</summary>
    Told,

    /// <summary>The validator accepted it; the inspection of the creature told what is broken, and the repair cured it.</summary>
    Repaired,

    /// <summary>The inspection told what is broken, and the repair did not cure all of it.</summary>
    Beyond,

    /// <summary>Something threw that should not.</summary>
    Crashed,

    /// <summary>Reading, building and inspecting took too much memory, or too long where the fuzzer has its process for itself.</summary>
    Dear,
}

/// <summary>An input put to the test. It has no clock: what a process does beside it is no property of the input.</summary>
/// <param name="Verdict">What came of it.</param>
/// <param name="Detail">What was broken, or thrown; empty for a sound creature.</param>
internal sealed record FuzzTrial(FuzzVerdict Verdict, string Detail)
{
    /// <summary>Most bytes allocated for an accepted input.</summary>
    private const long MaxBytes = 200 << 20;

    /// <summary>Reads, builds, inspects, and repairs what is broken.</summary>
    public static FuzzTrial Of(FuzzInput input) => Of(input, Repair);

    /// <summary>Reads alone: refused with a reason, or accepted.</summary>
    public static FuzzTrial WithoutCreature(FuzzInput input)
    {
        try
        {
            BlueprintReading reading = Read(input);
            return reading.Blueprint is not null ? new FuzzTrial(FuzzVerdict.Accepted, "")
                : reading.Problems.Count > 0 ? new FuzzTrial(FuzzVerdict.Refused, "")
                : new FuzzTrial(FuzzVerdict.Crashed, "refused without a reason");
        }
        catch (Exception problem) when (problem is not OutOfMemoryException)
        {
            return new FuzzTrial(FuzzVerdict.Crashed, problem.ToString());
        }
    }

    private static BlueprintReading Read(FuzzInput input)
    {
        using var stream = new MemoryStream(input.Text);
        return BlueprintJson.Read(stream);
    }

    /// <summary>Reads, builds and inspects.</summary>
    public static FuzzTrial WithoutRepair(FuzzInput input) => Of(input, (_, violations) => new FuzzTrial(FuzzVerdict.Told, NamesOf(violations)));

    private static FuzzTrial Of(FuzzInput input, Func<CreatureBlueprint, IReadOnlyList<InvariantViolation>, FuzzTrial> onBroken)
    {
        try
        {
            long bytes = GC.GetAllocatedBytesForCurrentThread();
            CreatureBlueprint? blueprint = Read(input).Blueprint;
            if (blueprint is null)
            {
                return new FuzzTrial(FuzzVerdict.Refused, "");
            }

            IReadOnlyList<InvariantViolation> violations = Build(blueprint);
            bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
            if (bytes > MaxBytes)
            {
                return new FuzzTrial(FuzzVerdict.Dear, $"{bytes >> 20} MiB");
            }

            return violations.Count == 0 ? new FuzzTrial(FuzzVerdict.Sound, "") : onBroken(blueprint, violations);
        }
        catch (Exception problem) when (problem is not OutOfMemoryException)
        {
            return new FuzzTrial(FuzzVerdict.Crashed, problem.ToString());
        }
    }

    private static string NamesOf(IReadOnlyList<InvariantViolation> violations) => string.Join(", ", violations.Select(v => v.Invariant));

    /// <summary>What the front door says of a blueprint that the validator accepts.</summary>
    private static IReadOnlyList<InvariantViolation> Build(CreatureBlueprint blueprint)
    {
        try
        {
            CreatureGenerator.Build(blueprint);
            return [];
        }
        catch (UnsoundCreatureException unsound)
        {
            return unsound.Violations;
        }
    }

    private static FuzzTrial Repair(CreatureBlueprint blueprint, IReadOnlyList<InvariantViolation> violations)
    {
        RepairReport report = BlueprintRepair.Repair(blueprint);
        string broken = NamesOf(violations);
        return report.IsSound
            ? new FuzzTrial(FuzzVerdict.Repaired, broken)
            : new FuzzTrial(FuzzVerdict.Beyond, broken + " -> " + string.Join(", ", report.Violations.Select(v => v.Invariant + ": " + v.Detail)));
    }
}
