using System;
using System.Collections.Concurrent;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Inspection;

/// <summary>What the library promises of every individual, over three of each of 300 species of each kind.</summary>
public sealed class EveryIndividualTests
{
    private const int Species = 300;
    private const int Individuals = 3;

    /// <summary>Per thousand creatures, as of the types.</summary>
    private const int MostSelfIntersecting = 3;

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void Every_individual_keeps_every_invariant(RequestedKind kind)
    {
        var violations = new ConcurrentBag<string>();
        int selfIntersecting = 0;
        Parallel.For(0, Species * Individuals, new ParallelOptions { CancellationToken = TestContext.Current.CancellationToken }, i =>
        {
            ulong seed = (ulong)(i / Individuals);
            ulong individual = (ulong)(i % Individuals) + (seed * 1000);
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Individual = individual });
            foreach (InvariantViolation violation in CreatureInspection.Inspect(creature))
            {
                violations.Add($"{kind} {seed}-{individual}: {violation.Invariant}: {violation.Detail}");
            }

            if (CreatureInspection.CountSelfIntersections(creature) > 0)
            {
                Interlocked.Increment(ref selfIntersecting);
            }
        });

        Assert.True(violations.IsEmpty, string.Join("\n", violations.OrderBy(line => line, StringComparer.Ordinal).Take(20)));
        Assert.InRange(selfIntersecting, 0, MostSelfIntersecting * Species * Individuals / 1000);
    }
}
