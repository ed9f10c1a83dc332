using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading;
using CreatureGen.Anatomy;
using CreatureGen.Benchmarks.Stages;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Table;

/// <summary>Our figures beside their targets, over many seeds of all kinds, in well under two minutes.</summary>
internal static class FiguresTable
{
    private const int WarmUpSeeds = 600;
    private const int Seeds = 600;

    /// <summary>Goes at each seed; the fastest counts, so that other programs on the machine do not.</summary>
    private const int Goes = 3;

    /// <summary>Creatures that each thread makes in one round of the batch.</summary>
    private const int BatchSeeds = 400;
    private const int BatchRounds = 5;

    private const double Megabyte = 1024 * 1024;

    /// <summary>Measures and prints.</summary>
    public static void Print(TextWriter output)
    {
        var watch = Stopwatch.StartNew();
        output.WriteLine(Line($"{Seeds} seeds of all kinds after {WarmUpSeeds} to warm up, the fastest of {Goes} goes at each; median and p99 are over seeds; {Environment.ProcessorCount} processors, .NET {Environment.Version}"));
        output.WriteLine();
        output.WriteLine("| work | median | p99 | target | median / target |");
        output.WriteLine("| --- | ---: | ---: | ---: | ---: |");
        Creatures(output);
        Lattices(output);
        Functions(output);
        output.WriteLine();
        Batch(output);
        output.WriteLine(Line($"measured in {watch.Elapsed.TotalSeconds:F0} s"));
    }

    private static void Creatures(TextWriter output)
    {
        var file = new MemoryStream(8 << 20);
        for (ulong seed = 0; seed < WarmUpSeeds; seed++)
        {
            Write(CreatureGenerator.Generate(1_000_000 + seed), file);
            if (seed % 50 == 49)
            {
                // Lets the compiler's background thread put the optimised code in place.
                Thread.Sleep(200);
            }
        }

        GC.Collect();
        Sample sampling = new(), sampleBytes = new(), assembly = new(), whole = new(), everyGo = new(), wholeBytes = new(), writing = new(), writingBytes = new(), size = new(), triangles = new(), vertices = new();
        var stages = new StageClock();
        Span<double> fastest = stackalloc double[4];
        for (ulong seed = 0; seed < Seeds; seed++)
        {
            fastest.Fill(double.MaxValue);
            stages.Begin();
            for (int go = 0; go < Goes; go++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                long start = Stopwatch.GetTimestamp();
                CreatureBlueprint blueprint = BlueprintSampler.Sample(seed);
                long sampled = Stopwatch.GetTimestamp();
                long sampledBytes = GC.GetAllocatedBytesForCurrentThread();
                Creature creature = CreatureAssembler.Assemble(blueprint);
                long assembled = Stopwatch.GetTimestamp();
                long assembledBytes = GC.GetAllocatedBytesForCurrentThread();
                Write(creature, file);
                long written = Stopwatch.GetTimestamp();
                long writtenBytes = GC.GetAllocatedBytesForCurrentThread();
                fastest[0] = Math.Min(fastest[0], Microseconds(start, sampled));
                fastest[1] = Math.Min(fastest[1], Microseconds(sampled, assembled));
                fastest[2] = Math.Min(fastest[2], Microseconds(start, assembled));
                fastest[3] = Math.Min(fastest[3], Microseconds(assembled, written));
                everyGo.Add(Microseconds(start, assembled));
                if (go == 0)
                {
                    sampleBytes.Add(sampledBytes - before);
                    wholeBytes.Add(assembledBytes - before);
                    writingBytes.Add(writtenBytes - assembledBytes);
                    size.Add(file.Position);
                    triangles.Add(creature.Mesh.Triangles.Length / 3);
                    vertices.Add(creature.Mesh.Positions.Length);
                }

                stages.Start();
                CreatureAssembler.Assemble(blueprint, stages);
            }

            sampling.Add(fastest[0]);
            assembly.Add(fastest[1]);
            whole.Add(fastest[2]);
            writing.Add(fastest[3]);
            stages.End();
        }

        Row(output, "blueprint from a seed, µs", sampling, 20);
        Row(output, "creature from a blueprint, µs", assembly, null);
        Row(output, "finished creature from a seed, µs", whole, 1000, 2000);
        Row(output, "– every go, collections of garbage and other programs included, µs", everyGo, null);
        foreach (AssemblyStage stage in Enum.GetValues<AssemblyStage>())
        {
            Row(output, Line($"– stage {stage}, µs"), stages.Microseconds(stage), null);
        }

        Row(output, "allocated by a finished creature, MB", wholeBytes, 2, null, Megabyte);
        Row(output, "– blueprint from a seed, MB", sampleBytes, null, null, Megabyte);
        foreach (AssemblyStage stage in Enum.GetValues<AssemblyStage>())
        {
            Row(output, Line($"– stage {stage}, MB"), stages.Bytes(stage), null, null, Megabyte);
        }

        Row(output, "GLB in memory, no clips, µs", writing, 400);
        Row(output, "– allocated, MB", writingBytes, null, null, Megabyte);
        Row(output, "– size of the file, MB", size, null, null, Megabyte);
        Row(output, "triangles of a creature", triangles, null);
        Row(output, "vertices of a creature", vertices, null);
    }

    private static void Lattices(TextWriter output)
    {
        var work = new LatticeWork();
        Row(output, "lattice 3 × 3 × 11, ns per free point", Repeat(work.DeformPoints, LatticeWork.Points), 6);
        Row(output, "lattice, ns per vertex of the body's rings", Repeat(work.ScaleRings, BodyGrid.Rings * BodyGrid.Segments), 2);
    }

    private static void Functions(TextWriter output)
    {
        double[] x = PortableMathWork.Arguments();
        Beside("Sin", PortableMathWork.Sin, PortableMathWork.RuntimeSin);
        Beside("Pow", PortableMathWork.Pow, PortableMathWork.RuntimePow);
        Beside("Exp", PortableMathWork.Exp, PortableMathWork.RuntimeExp);
        Beside("Atan2", PortableMathWork.Atan2, PortableMathWork.RuntimeAtan2);

        void Beside(string name, Func<double[], double> portable, Func<double[], double> runtime)
        {
            // No target of its own: what counts is the distance to the C runtime, measured in the same run.
            Sample theirs = Repeat(() => runtime(x), PortableMathWork.Count);
            Row(output, Line($"{name}, ns, beside the C runtime's"), Repeat(() => portable(x), PortableMathWork.Count), theirs.Median);
        }
    }

    private static Sample Repeat(Action action, int operations)
    {
        const int Rounds = 400;
        for (int i = 0; i < Rounds; i++)
        {
            action();
        }

        Thread.Sleep(200);
        var sample = new Sample();
        for (int i = 0; i < Rounds; i++)
        {
            long start = Stopwatch.GetTimestamp();
            action();
            sample.Add(Microseconds(start, Stopwatch.GetTimestamp()) * 1000 / operations);
        }

        return sample;
    }

    /// <summary>Creatures per second on one thread and on two, in turns, so that both see the same machine.</summary>
    private static void Batch(TextWriter output)
    {
        Sample one = new(), two = new(), ratio = new();
        for (int round = 0; round < BatchRounds; round++)
        {
            double single = CreaturesPerSecond(1);
            double both = CreaturesPerSecond(2);
            one.Add(single);
            two.Add(both);
            ratio.Add(both / single);
        }

        output.WriteLine(Line($"creatures per second: {one.Median:F0} on 1 thread, {two.Median:F0} on 2; scaling {ratio.Median:F2} (target at least 1.9; means little while others use the machine)"));
    }

    private static double CreaturesPerSecond(int threads)
    {
        var workers = new Thread[threads];
        long start = Stopwatch.GetTimestamp();
        for (int t = 0; t < threads; t++)
        {
            ulong first = (ulong)(t * BatchSeeds);
            workers[t] = new Thread(() =>
            {
                for (ulong seed = first; seed < first + BatchSeeds; seed++)
                {
                    CreatureGenerator.Generate(seed);
                }
            });
            workers[t].Start();
        }

        foreach (Thread worker in workers)
        {
            worker.Join();
        }

        return threads * BatchSeeds / (Microseconds(start, Stopwatch.GetTimestamp()) / 1e6);
    }

    private static void Write(Creature creature, MemoryStream file)
    {
        file.Position = 0;
        GlbWriter.Write(creature, GltfOptions.Default, file);
    }

    private static double Microseconds(long start, long end) => (end - start) * 1e6 / Stopwatch.Frequency;

    private static void Row(TextWriter output, string work, Sample sample, double? target, double? targetP99 = null, double unit = 1)
    {
        string goal = target is double t ? Number(t) + (targetP99 is double p ? " (p99 " + Number(p) + ")" : "") : "–";
        string ratio = target is double of ? Line($"{sample.Median / unit / of:F2}") : "–";
        output.WriteLine(Line($"| {work} | {Number(sample.Median / unit)} | {Number(sample.P99 / unit)} | {goal} | {ratio} |"));
    }

    private static string Number(double value) => Math.Abs(value) >= 100 ? Line($"{value:F0}") : Line($"{value:F2}");

    private static string Line(FormattableString text) => FormattableString.Invariant(text);
}
