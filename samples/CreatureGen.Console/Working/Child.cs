using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics;

namespace CreatureGen.Console.Working;

/// <summary>A child and its files.</summary>
/// <param name="Name">The number by which it is known, in hexadecimal digits.</param>
/// <param name="Creature">The child at the age that was asked for.</param>
/// <param name="Offspring">The grown child.</param>
/// <param name="Files">Its files.</param>
internal sealed record Child(string Name, Creature Creature, Offspring Offspring, IReadOnlyList<CreatureFile> Files)
{
    /// <summary>From which parent each group comes, in letters: <c>frame A head B tail A ornaments B skin B</c>.</summary>
    public string Inherited()
    {
        LineageBlueprint lineage = Offspring.Blueprint.Lineage!;
        return $"frame {Letter(lineage.Frame)} head {Letter(lineage.Head)} tail {Letter(lineage.Tail)} ornaments {Letter(lineage.Ornaments)} skin {Letter(lineage.Skin)}";
    }

    private static char Letter(ParentName parent) => parent == ParentName.First ? 'A' : 'B';
}
