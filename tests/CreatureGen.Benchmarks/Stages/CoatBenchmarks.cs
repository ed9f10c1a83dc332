using System.Numerics;
using BenchmarkDotNet.Attributes;
using CreatureGen.Appearance;
using CreatureGen.Geometry;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>The colour of each vertex.</summary>
public class CoatBenchmarks : StageBenchmark
{
    private Vector3[] colours = System.Array.Empty<Vector3>();

    /// <inheritdoc/>
    public override void SetUp()
    {
        base.SetUp();
        colours = new Vector3[Subject.Normals.Length];
    }

    /// <summary>Colours of all vertices of the surface.</summary>
    [Benchmark]
    public void Paint()
    {
        Surface surface = Subject.Grown.Surface;
        Subject.Painter.Paint(surface.Addresses, surface.Positions, surface.Mirror, Subject.Normals, colours);
    }
}
