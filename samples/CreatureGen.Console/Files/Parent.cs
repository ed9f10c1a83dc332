using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Files;

/// <summary>A creature that is bred: that of a seed or that in a file.</summary>
/// <param name="Name">What was typed.</param>
/// <param name="Blueprint">The creature.</param>
internal sealed record Parent(string Name, CreatureBlueprint Blueprint)
{
    /// <summary>Takes digits for a seed, of its natural kind, and all else for a file.</summary>
    /// <exception cref="UsageError">There is no such creature.</exception>
    public static Parent Read(string operand, Surroundings surroundings) => SeedText.TryRead(operand, out ulong seed)
        ? new Parent(operand, Growing.Sample(seed, CreatureOptions.Default))
        : new Parent(operand, CreatureSource.Read(operand, surroundings).Blueprint);
}
