using BenchmarkDotNet.Attributes;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>The body without its limbs.</summary>
public class BodyBenchmarks : StageBenchmark
{
    /// <summary>Stations, slices and posture to 55 sections along the spine.</summary>
    [Benchmark]
    public object Shape()
    {
        CreatureBlueprint blueprint = Subject.Blueprint;
        return BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
    }

    /// <summary>The 55 × 32 points of the skin and their normals.</summary>
    [Benchmark]
    public object Skin() => BodySkin.Span(Subject.Shape, Subject.Blueprint);
}
