using System.Collections.Generic;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>Two creatures that have a child.</summary>
/// <param name="First">One parent.</param>
/// <param name="Second">The other; the same one for a child by mutation alone.</param>
public readonly record struct Couple(Individual First, Individual Second);

/// <summary>Who has children, and who lives on. Pure: asked on any thread, and the same question has the same answer.</summary>
public interface ISelection
{
    /// <summary>A word for reports.</summary>
    string Name { get; }

    /// <summary>Chooses the parents of a child.</summary>
    /// <param name="generation">Who there is.</param>
    /// <param name="random">The child's own numbers.</param>
    Couple Choose(Generation generation, RandomStream random);

    /// <summary>The next generation.</summary>
    /// <param name="generation">The one before, scored among its children.</param>
    /// <param name="children">Theirs.</param>
    /// <param name="room">Creatures of a generation.</param>
    Generation Succeed(Generation generation, IReadOnlyList<Individual> children, int room);
}
