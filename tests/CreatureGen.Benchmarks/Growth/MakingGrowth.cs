using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>What growing a creature costs against its triangles, its legs, threads, and how many have been grown.</summary>
internal static class MakingGrowth
{
    private const int Bodies = 15;
    private const int Rounds = 4;

    /// <summary>Creatures that are grown in all for the plot of memory, and between two looks at it.</summary>
    private const int Grown = 10_000;
    private const int GrownBetween = 1_000;

    /// <summary>Creatures of a round of the plot of threads.</summary>
    private const int Batch = 200;

    private const double Megabyte = 1024 * 1024;

    private static readonly int[] budgets = { 6_000, 7_000, 8_000, 10_000, 12_000, 16_000, 20_000, 30_000 };
    private static readonly int[] legPairs = { 0, 1, 2, 3, 4, 6, 8, 12, 16 };

    /// <summary>All plots.</summary>
    public static IEnumerable<Plot> Plots()
    {
        yield return new Plot("A creature against the budget of triangles", "triangles allowed", "ms", PlotScale.Linear, new[] { Median("median of all kinds", budgets, budget => CreatureOptions.Default with { TriangleBudget = budget }) });
        yield return new Plot("A walker against its legs and arms", "pairs of limbs", "ms", PlotScale.Linear, new[] { Median("median", legPairs, pairs => CreatureOptions.Default with { Kind = RequestedKind.Walking, MinLegPairs = pairs, MaxLegPairs = pairs }) });
        yield return new Plot("Creatures grown at once", "threads", "creatures a second", PlotScale.Linear, new[] { Fastest.Warm(Threads) });
        yield return new Plot("Memory as creatures are grown and let go", "creatures grown", "MB", PlotScale.Linear, Memory());
    }

    private static PlotSeries Median(string name, int[] values, Func<int, CreatureOptions> options) => Fastest.Warm(() => new PlotSeries(name, values.Select(value =>
    {
        double[] costs = new double[Bodies];
        for (int i = 0; i < Bodies; i++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)i + 1, options(value));
            costs[i] = Fastest.Of(Rounds, () => CreatureAssembler.Assemble(blueprint)) / 1000;
        }

        Array.Sort(costs);
        return ((double)value, costs[Bodies / 2]);
    }).ToArray()));

    private static PlotSeries Threads()
    {
        var points = new List<(double, double)>();
        for (int threads = 1; threads <= Environment.ProcessorCount; threads++)
        {
            int degree = threads;
            double taken = Fastest.Of(Rounds, () => Parallel.For(0, Batch, new ParallelOptions { MaxDegreeOfParallelism = degree }, i => CreatureGenerator.Generate((ulong)i)));
            points.Add((threads, Batch / taken * 1e6));
        }

        return new PlotSeries("all kinds", points);
    }

    /// <summary>What stays after a full collection, and what the process has taken of the machine.</summary>
    private static PlotSeries[] Memory()
    {
        List<(double, double)> kept = new(), working = new();
        for (int count = 0; count <= Grown; count++)
        {
            CreatureGenerator.Generate((ulong)count);
            if (count % GrownBetween == 0)
            {
                working.Add((count, Environment.WorkingSet / Megabyte));
                kept.Add((count, GC.GetTotalMemory(forceFullCollection: true) / Megabyte));
            }
        }

        return new[] { new PlotSeries("working set", working), new PlotSeries("kept after a collection", kept) };
    }
}
