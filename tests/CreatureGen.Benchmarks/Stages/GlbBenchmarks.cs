using System.IO;
using BenchmarkDotNet.Attributes;
using CreatureGen.Gltf;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Creature to GLB, in memory.</summary>
public class GlbBenchmarks : StageBenchmark
{
    private readonly MemoryStream stream = new(4 << 20);

    /// <summary>The whole file.</summary>
    [Benchmark]
    public long Write()
    {
        stream.Position = 0;
        GlbWriter.Write(Subject.Creature, GltfOptions.Default, stream);
        return stream.Position;
    }
}
