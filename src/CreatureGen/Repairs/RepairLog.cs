using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Repairs;

/// <summary>A blueprint under repair and all that was changed in it.</summary>
internal sealed class RepairLog
{
    private readonly List<RepairChange> changes = new();

    public RepairLog(CreatureBlueprint blueprint) => Blueprint = blueprint;

    /// <summary>The blueprint as it is now.</summary>
    public CreatureBlueprint Blueprint { get; private set; }

    /// <summary>What was changed, each field once.</summary>
    public IReadOnlyList<RepairChange> Changes => changes.FindAll(change => change.From != change.To);

    /// <summary>Goes on with another blueprint. False if it is the same.</summary>
    public bool Change(CreatureBlueprint changed, string reason)
    {
        CreatureBlueprint limited = FieldLimiter.Limit(changed, CreatureFields.Creature);
        if (limited.Equals(Blueprint))
        {
            return false;
        }

        foreach (FieldDifference difference in FieldDifference.Between(Blueprint, limited))
        {
            Add(difference, reason);
        }

        Blueprint = limited;
        return true;
    }

    private void Add(FieldDifference difference, string reason)
    {
        int known = changes.FindIndex(change => change.Path == difference.Path);
        if (known >= 0)
        {
            changes[known] = changes[known] with { To = difference.To };
            return;
        }

        changes.Add(new RepairChange(difference.Path, difference.From, difference.To, reason));
    }
}
