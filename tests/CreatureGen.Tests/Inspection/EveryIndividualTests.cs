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

/// <summary>What the library promises of every individual, over three of each of 40 species of each kind, and of 300 when all is asked for.</summary>
public sealed class EveryIndividualTests
{
    private const int Individuals = 3;

    /// <summary>Per thousand animals, as of the types.</summary>
    private const int MaxSelfIntersecting = 3;

    /// <summary>Per thousand creatures whose parts are of several animals: individuals stretch what their type has just kept apart. As measured.</summary>
    private const int MaxStrangeSelfIntersecting = 11;

    [Theory]
    [InlineData(RequestedKind.Walking, 4, 0)]
    [InlineData(RequestedKind.Walking, 4, 0.6)]
    [InlineData(RequestedKind.Flying, 4, 0)]
    [InlineData(RequestedKind.Flying, 4, 0.6)]
    [InlineData(RequestedKind.Swimming, 4, 0)]
    [InlineData(RequestedKind.Swimming, 4, 0.6)]
    [InlineData(RequestedKind.Walking, 300, 0, Explicit = true)]
    [InlineData(RequestedKind.Walking, 300, 0.6, Explicit = true)]
    [InlineData(RequestedKind.Flying, 300, 0, Explicit = true)]
    [InlineData(RequestedKind.Flying, 300, 0.6, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 300, 0, Explicit = true)]
    [InlineData(RequestedKind.Swimming, 300, 0.6, Explicit = true)]
    public void Every_individual_keeps_every_invariant(RequestedKind kind, int species, double strangeness)
    {
        var violations = new ConcurrentBag<string>();
        int selfIntersecting = 0;
        Parallel.For(0, species * Individuals, new ParallelOptions { CancellationToken = TestContext.Current.CancellationToken }, i =>
        {
            ulong seed = (ulong)(i / Individuals);
            ulong individual = (ulong)(i % Individuals) + (seed * 1000);
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = strangeness, Individual = individual });
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
        Assert.InRange(selfIntersecting, 0, Math.Max(1, (strangeness > 0 ? MaxStrangeSelfIntersecting : MaxSelfIntersecting) * species * Individuals / 1000));
    }
}
