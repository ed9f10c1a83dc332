using System;
using System.Collections.Generic;

namespace CreatureGen.Inspection;

/// <summary>What an inspection has found: the first violation of each invariant, since one defect shows in many places.</summary>
internal sealed class ViolationList
{
    private readonly List<InvariantViolation> violations = new();

    public IReadOnlyList<InvariantViolation> All => violations;

    /// <summary>Notes a violation, unless the invariant is broken already.</summary>
    public void Add(string invariant, FormattableString detail)
    {
        foreach (InvariantViolation known in violations)
        {
            if (known.Invariant == invariant)
            {
                return;
            }
        }

        violations.Add(new InvariantViolation(invariant, FormattableString.Invariant(detail)));
    }
}
