using BenchmarkDotNet.Attributes;
using CreatureGen.Geometry;
using CreatureGen.Limbs;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>The welded surface of body and limbs.</summary>
public class SurfaceBenchmarks : StageBenchmark
{
    /// <summary>Body shape and skin, all limbs, mouth, neighbourhoods and relaxed seams.</summary>
    [Benchmark]
    public object Grow() => GrownSurface.Grow(Subject.Blueprint);

    /// <summary>Smooth normals.</summary>
    [Benchmark]
    public void Normals() => SurfaceNormals.Smooth(Subject.Grown.Surface.Positions, Subject.Grown.Surface.Triangles, Subject.Normals);

    /// <summary>The neighbours of every vertex.</summary>
    [Benchmark]
    public object Adjacency() => new SurfaceAdjacency(Subject.Grown.Surface.Positions.Length, Subject.Grown.Surface.Faces);
}
