using System;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Working;

/// <summary>From a seed to its blueprint, for options that somebody typed.</summary>
internal static class Growing
{
    /// <summary>The blueprint of a seed within options.</summary>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options) => Sample(seed, options, out _);

    /// <summary>The same, and how the sockets of its limbs were given out.</summary>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options, out SocketTally sockets)
    {
        try
        {
            return BlueprintSampler.Sample(seed, options, out sockets);
        }
        catch (ImpossibleSeedException problem)
        {
            throw new ImpossibleSeed(WithoutParameter(problem));
        }
        catch (ArgumentException problem)
        {
            throw new UsageError(WithoutParameter(problem));
        }
    }

    private static string WithoutParameter(ArgumentException problem)
    {
        int end = problem.Message.LastIndexOf(" (Parameter", StringComparison.Ordinal);
        return end < 0 ? problem.Message : problem.Message[..end];
    }
}
