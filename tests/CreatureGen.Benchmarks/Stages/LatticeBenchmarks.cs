using System;
using System.Numerics;
using BenchmarkDotNet.Attributes;
using CreatureGen.Anatomy;
using CreatureGen.Lattices;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Free-form deformation: a lattice of 3 × 3 × 11 on free points, and its contraction on the rings of the body.</summary>
[MemoryDiagnoser]
public class LatticeBenchmarks
{
    private readonly LatticeWork work = new();

    /// <summary>Per free point.</summary>
    [Benchmark(OperationsPerInvoke = LatticeWork.Points)]
    public void FreePoints() => work.DeformPoints();

    /// <summary>Per vertex of the body's 55 rings of 32, all rings contracted in one go.</summary>
    [Benchmark(OperationsPerInvoke = BodyGrid.Rings * BodyGrid.Segments)]
    public void RingVertices() => work.ScaleRings();
}

/// <summary>The same points and slices for BenchmarkDotNet and for the table.</summary>
internal sealed class LatticeWork
{
    public const int Points = 4096;

    private const int Slices = 11;

    private readonly FreeFormLattice lattice;
    private readonly Vector3[] points = new Vector3[Points];
    private readonly Vector3[] deformed = new Vector3[Points];
    private readonly double[] slices = new double[Slices];
    private readonly double[] places = new double[BodyGrid.Rings];
    private readonly double[] widths = new double[BodyGrid.Rings];
    private readonly double[] heights = new double[BodyGrid.Rings];
    private readonly double[] positions = new double[BodyGrid.Rings];

    public LatticeWork()
    {
        var offsets = new Vector3[99];
        for (int i = 0; i < offsets.Length; i++)
        {
            offsets[i] = new Vector3(i % 3, i % 7, i % 5) * 0.01f;
        }

        lattice = new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ).WithOffsets(offsets);
        for (int i = 0; i < Points; i++)
        {
            points[i] = new Vector3(i % 16, i / 16 % 16, i / 256) / 16f;
        }

        for (int i = 0; i < Slices; i++)
        {
            slices[i] = 0.8 + (0.04 * i);
        }

        for (int i = 0; i < places.Length; i++)
        {
            places[i] = i / (double)(places.Length - 1);
        }
    }

    public void DeformPoints() => lattice.Deform(points, deformed);

    public void ScaleRings() => RingLattice.Evaluate(slices, slices, slices, places, widths, heights, positions);
}
