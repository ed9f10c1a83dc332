using BenchmarkDotNet.Attributes;
using CreatureGen.Creatures;
using CreatureGen.Geometry;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Vertex buffers, volume and mass.</summary>
public class MeshBenchmarks : StageBenchmark
{
    /// <summary>Texture charts, split vertices, pieces, parts.</summary>
    [Benchmark]
    public object Assemble() => MeshAssembler.Assemble(new Body(Subject.Grown.Surface, Subject.Normals, Subject.Normals, Subject.Weights, Subject.Pieces, Subject.Rig), 1f);

    /// <summary>Volume, centre and inertia of the surface.</summary>
    [Benchmark]
    public object Weigh() => SolidProperties.Of(Subject.Grown.Surface.Positions, Subject.Grown.Surface.Triangles);
}
