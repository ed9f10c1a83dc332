using System;
using System.Threading;

namespace CreatureGen.Genetics.Populations;

/// <summary>How a population is bred on. The same settings, founders and goal give the same generations.</summary>
public sealed record EvolutionSettings
{
    /// <summary>Greatest population.</summary>
    public const int MaxIndividuals = 10_000;

    private readonly int population = 64;
    private readonly BreedingSettings breeding = BreedingSettings.Default;
    private readonly ISelection selection = new TournamentSelection();

    /// <summary>64 creatures, a mutation of 0.2, tournaments.</summary>
    public static EvolutionSettings Default { get; } = new();

    /// <summary>Creatures of a generation, 2..10,000.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not in its range.</exception>
    public int Population
    {
        get => population;
        init => population = value is >= 2 and <= MaxIndividuals ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "expected 2..10000");
    }

    /// <summary>Which of the courses that this evolution could take.</summary>
    public ulong Seed { get; init; } = 1;

    /// <summary>How children are bred.</summary>
    public BreedingSettings Breeding
    {
        get => breeding;
        init => breeding = value ?? throw new ArgumentNullException(nameof(value));
    }

    /// <summary>Who has children, and who lives on.</summary>
    public ISelection Selection
    {
        get => selection;
        init => selection = value ?? throw new ArgumentNullException(nameof(value));
    }
}

/// <summary>How the work of a generation is done. Nothing of it changes what comes out.</summary>
public sealed record EvolutionWork
{
    private readonly int threads = 1;

    /// <summary>One thread, without an end before its time.</summary>
    public static EvolutionWork Default { get; } = new();

    /// <summary>Threads that share the work, at least 1, which is the default.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 1.</exception>
    public int Threads
    {
        get => threads;
        init => threads = value >= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "expected at least 1");
    }

    /// <summary>Stops between creatures.</summary>
    public CancellationToken Cancellation { get; init; }

    /// <summary>Called when a creature is born or judged in motion, on any thread; null for nobody.</summary>
    public Action? Progress { get; init; }
}
