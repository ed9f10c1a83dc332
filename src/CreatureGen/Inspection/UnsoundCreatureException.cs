using System;
using System.Collections.Generic;
using System.Text;

namespace CreatureGen.Inspection;

/// <summary>A blueprint that its validator accepts builds a creature that breaks what the library promises of creatures.</summary>
public sealed class UnsoundCreatureException : ArgumentException
{
    internal UnsoundCreatureException(IReadOnlyList<InvariantViolation> violations, string parameter)
        : base(Text(violations), parameter) => Violations = violations;

    /// <summary>All that is broken, as <see cref="CreatureInspection.Inspect"/> tells it; not empty.</summary>
    public IReadOnlyList<InvariantViolation> Violations { get; }

    private static string Text(IReadOnlyList<InvariantViolation> violations)
    {
        var text = new StringBuilder("the creature of this blueprint is not sound, BlueprintRepair may mend it:");
        foreach (InvariantViolation violation in violations)
        {
            text.Append('\n').Append(violation.Invariant).Append(": ").Append(violation.Detail);
        }

        return text.ToString();
    }
}
