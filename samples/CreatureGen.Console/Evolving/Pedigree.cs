using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Blueprints;

namespace CreatureGen.Console.Evolving;

/// <summary>An ancestor in a family tree.</summary>
/// <param name="Ancestor">Who.</param>
/// <param name="Share">Which part of the descendant's pedigree goes through it, 0..1.</param>
internal sealed record PedigreeEntry(Ancestor Ancestor, double Share);

/// <summary>Who descends from whom in a run. A parent gives one half, and the halves multiply from generation to generation.</summary>
internal sealed class Pedigree(EvolutionRun run)
{
    private readonly Dictionary<ulong, Ancestor> known = run.Ancestors.ToDictionary(one => one.Identity);

    /// <summary>
    /// The ancestors of a creature as of a generation: from the creature upwards through both parents as long as they were born later. Their shares add up to 1; the greatest first, and of equal ones the older.
    /// </summary>
    public IReadOnlyList<PedigreeEntry> AncestorsAt(ulong descendant, int generation)
    {
        // Children are always younger than their parents: taken from the youngest, everybody's share is complete when it is passed on.
        var shares = new Dictionary<ulong, double> { [descendant] = 1 };
        var order = new PriorityQueue<ulong, (int Born, ulong Identity)>();
        order.Enqueue(descendant, Key(descendant));
        var found = new List<PedigreeEntry>();
        while (order.TryDequeue(out ulong identity, out _))
        {
            Ancestor one = known[identity];
            double share = shares[identity];
            if (one.Born <= generation || one.Lineage is not LineageBlueprint lineage || !known.ContainsKey(lineage.First) || !known.ContainsKey(lineage.Second))
            {
                found.Add(new PedigreeEntry(one, share));
                continue;
            }

            Pass(lineage.First, share / 2);
            Pass(lineage.Second, share / 2);
        }

        return found.OrderByDescending(entry => entry.Share).ThenBy(entry => entry.Ancestor.Born).ThenBy(entry => entry.Ancestor.Identity).ToArray();

        void Pass(ulong parent, double share)
        {
            if (!shares.TryAdd(parent, share))
            {
                shares[parent] += share;
                return;
            }

            order.Enqueue(parent, Key(parent));
        }

        (int, ulong) Key(ulong identity) => (-known[identity].Born, identity);
    }
}
