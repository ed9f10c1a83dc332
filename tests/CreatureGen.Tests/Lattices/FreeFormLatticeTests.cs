using System;
using System.Numerics;
using CreatureGen.Lattices;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Lattices;

public sealed class FreeFormLatticeTests
{
    private static readonly FreeFormLattice Skewed = new(new Vector3(0.3f, -0.2f, 0.7f), new Vector3(1.1f, 0.2f, -0.1f), new Vector3(-0.3f, 0.9f, 0.25f), new Vector3(0.2f, -0.4f, 1.6f));

    private readonly RandomStream stream = new(55);

    [Fact]
    public void Without_degrees_it_has_the_three_by_three_by_eleven_points_of_a_body()
    {
        Assert.Equal(99, Skewed.Offsets.Length);
        Assert.Equal((2, 2, 10), (Skewed.DegreeS, Skewed.DegreeT, Skewed.DegreeU));
        Assert.Equal(Skewed.Origin, Skewed.ControlPoint(0, 0, 0));
        Close(Skewed.Origin + Skewed.AxisS + Skewed.AxisT + Skewed.AxisU, Skewed.ControlPoint(2, 2, 10));
        Close(Skewed.Origin + (Skewed.AxisS / 2) + (Skewed.AxisU * 0.3f), Skewed.ControlPoint(1, 0, 3));
        Assert.Equal((3 * 9) + (2 * 3) + 1, Skewed.IndexOf(1, 2, 3));
    }

    [Fact]
    public void At_rest_nothing_moves_by_a_single_bit()
    {
        for (int i = 0; i < 2000; i++)
        {
            Vector3 p = Inside(Skewed) + (i % 2 == 0 ? Vector3.Zero : new Vector3(5, -7, 9));
            Assert.Equal(p, Skewed.Deform(p));
        }
    }

    [Fact]
    public void Local_coordinates_are_those_the_point_was_made_of()
    {
        var mirrored = new FreeFormLattice(Vector3.One, Vector3.UnitY, Vector3.UnitX * 3, Vector3.UnitZ * 0.1f);
        foreach (FreeFormLattice lattice in new[] { Skewed, mirrored })
        {
            for (int i = 0; i < 1000; i++)
            {
                var local = new Vector3((float)stream.Uniform(-1, 2), (float)stream.Uniform(-1, 2), (float)stream.Uniform(-1, 2));
                Vector3 p = lattice.Origin + (lattice.AxisS * local.X) + (lattice.AxisT * local.Y) + (lattice.AxisU * local.Z);
                Close(local, lattice.Local(p), 5e-6f);
            }
        }
    }

    [Fact]
    public void A_point_moves_by_the_products_of_binomials_known_by_hand()
    {
        var cube = new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, 1, 1, 1);
        var offsets = new Vector3[8];
        offsets[cube.IndexOf(1, 1, 1)] = new Vector3(0, 0, 1);
        FreeFormLattice pulled = cube.WithOffsets(offsets);
        Assert.Equal(new Vector3(0.5f, 0.5f, 0.625f), pulled.Deform(new Vector3(0.5f)));
        Assert.Equal(new Vector3(1, 1, 2), pulled.Deform(Vector3.One));
        Assert.Equal(new Vector3(1, 0.5f, 1.5f), pulled.Deform(new Vector3(1, 0.5f, 1)));
        Assert.Equal(Vector3.UnitX, pulled.Deform(Vector3.UnitX));

        // The middle point of 3 × 3 × 11: ½ · ½ · 252/1024 of its offset arrives in the middle.
        var body = new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ);
        offsets = new Vector3[99];
        offsets[body.IndexOf(1, 1, 5)] = new Vector3(16, 0, -32);
        Assert.Equal(new Vector3(0.5f + (16 * 0.0615234375f), 0.5f, 0.5f - (32 * 0.0615234375f)), body.WithOffsets(offsets).Deform(new Vector3(0.5f)));
    }

    [Fact]
    public void The_deformed_point_is_the_sum_over_control_points_of_the_paper()
    {
        FreeFormLattice[] lattices = { Skewed, new(Vector3.Zero, Vector3.UnitZ, Vector3.UnitX * 2, Vector3.UnitY, 3, 1, 5) };
        foreach (FreeFormLattice rest in lattices)
        {
            FreeFormLattice lattice = rest.WithOffsets(Random(rest, 0.4));
            for (int n = 0; n < 500; n++)
            {
                Vector3 p = Inside(lattice);
                Vector3 local = lattice.Local(p);
                double x = 0, y = 0, z = 0;
                for (int i = 0; i <= lattice.DegreeS; i++)
                {
                    for (int j = 0; j <= lattice.DegreeT; j++)
                    {
                        for (int k = 0; k <= lattice.DegreeU; k++)
                        {
                            double weight = Weight(lattice.DegreeS, i, local.X) * Weight(lattice.DegreeT, j, local.Y) * Weight(lattice.DegreeU, k, local.Z);
                            Vector3 c = lattice.ControlPoint(i, j, k);
                            x += weight * c.X;
                            y += weight * c.Y;
                            z += weight * c.Z;
                        }
                    }
                }

                Close(new Vector3((float)x, (float)y, (float)z), lattice.Deform(p), 2e-6f);
            }
        }
    }

    [Fact]
    public void Control_points_moved_together_move_all_points_as_much()
    {
        var shift = new Vector3(0.25f, -3, 2);
        var offsets = new Vector3[99];
        Array.Fill(offsets, shift);
        FreeFormLattice lattice = Skewed.WithOffsets(offsets);
        for (int i = 0; i < 1000; i++)
        {
            Vector3 p = Inside(lattice);
            Close(p + shift, lattice.Deform(p));
        }
    }

    [Fact]
    public void Control_points_moved_by_an_affine_map_move_all_points_by_it()
    {
        for (int trial = 0; trial < 50; trial++)
        {
            Vector3 x = Any(1.5), y = Any(1.5), z = Any(1.5), origin = Any(2);
            Vector3 Map(Vector3 p) => origin + (x * p.X) + (y * p.Y) + (z * p.Z);
            var offsets = new Vector3[99];
            for (int k = 0; k <= 10; k++)
            {
                for (int j = 0; j <= 2; j++)
                {
                    for (int i = 0; i <= 2; i++)
                    {
                        Vector3 rest = Skewed.RestPoint(i, j, k);
                        offsets[Skewed.IndexOf(i, j, k)] = Map(rest) - rest;
                    }
                }
            }

            FreeFormLattice lattice = Skewed.WithOffsets(offsets);
            for (int i = 0; i < 50; i++)
            {
                Vector3 p = Inside(lattice);
                Close(Map(p), lattice.Deform(p), 3e-6f);
            }
        }
    }

    [Fact]
    public void A_displaced_lattice_mapped_as_a_whole_maps_its_results()
    {
        Vector3[] offsets = Random(Skewed, 0.3);
        Quaternion turn = Rotation.FromAxisAngle(Vec.Normalize(new Vector3(1, 2, 3)), 0.8);
        var shift = new Vector3(0.5f, 1, -1);
        Vector3 Map(Vector3 v) => Vec.Mirror(Rotation.Rotate(turn, v)) * 1.5f;
        FreeFormLattice here = Skewed.WithOffsets(offsets);
        FreeFormLattice there = new FreeFormLattice(Map(Skewed.Origin) + shift, Map(Skewed.AxisS), Map(Skewed.AxisT), Map(Skewed.AxisU)).WithOffsets(Array.ConvertAll(offsets, Map));
        for (int i = 0; i < 500; i++)
        {
            Vector3 p = Inside(here);
            Close(Map(here.Deform(p)) + shift, there.Deform(Map(p) + shift), 4e-6f);
        }
    }

    [Fact]
    public void Corners_go_to_their_control_points()
    {
        FreeFormLattice lattice = Skewed.WithOffsets(Random(Skewed, 0.4));
        foreach (int i in new[] { 0, 2 })
        {
            foreach (int j in new[] { 0, 2 })
            {
                foreach (int k in new[] { 0, 10 })
                {
                    Close(lattice.ControlPoint(i, j, k), lattice.Deform(lattice.RestPoint(i, j, k)), 2e-6f);
                }
            }
        }
    }

    [Fact]
    public void A_point_outside_moves_with_the_nearest_point_of_the_boundary()
    {
        var box = new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ);
        FreeFormLattice lattice = box.WithOffsets(Random(box, 0.4));
        var outside = new Vector3(0.25f, 3, -8);
        var edge = new Vector3(0.25f, 1, 0);
        Close(lattice.Deform(edge) - edge, lattice.Deform(outside) - outside);
    }

    [Fact]
    public void Many_points_at_once_are_the_same_as_one_by_one_even_in_place()
    {
        FreeFormLattice lattice = Skewed.WithOffsets(Random(Skewed, 0.4));
        var points = new Vector3[100];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = Inside(lattice);
        }

        Vector3[] expected = Array.ConvertAll(points, lattice.Deform);
        long before = GC.GetAllocatedBytesForCurrentThread();
        lattice.Deform(points, points);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.Equal(expected, points);
    }

    [Fact]
    public void Displacing_leaves_the_lattice_it_came_from_as_it_was()
    {
        Vector3[] offsets = Random(Skewed, 1);
        FreeFormLattice lattice = Skewed.WithOffsets(offsets);
        offsets[0] = new Vector3(100);
        Assert.NotEqual(offsets[0], lattice.Offsets[0]);
        Assert.Equal(Vector3.Zero, Skewed.Offsets[50]);
    }

    [Fact]
    public void Lattices_and_points_without_meaning_are_refused()
    {
        Assert.Contains("no volume", Assert.Throws<ArgumentException>(() => new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, new Vector3(1, 1, 0))).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.Zero, Vector3.UnitZ));
        Assert.Throws<ArgumentException>(() => new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, new Vector3(0, 0, float.NaN)));
        Assert.Throws<ArgumentException>(() => new FreeFormLattice(new Vector3(float.PositiveInfinity), Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FreeFormLattice(Vector3.Zero, Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, degreeU: 32));
        Assert.Throws<ArgumentException>(() => Skewed.WithOffsets(new Vector3[98]));
        var offsets = new Vector3[99];
        offsets[7].Y = float.NaN;
        Assert.Contains("offset 7", Assert.Throws<ArgumentException>(() => Skewed.WithOffsets(offsets)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => Skewed.Deform(new Vector3(float.NaN, 0, 0)));
        Assert.Throws<ArgumentException>(() => Skewed.Deform(new Vector3[2], new Vector3[3]));
        Assert.Throws<ArgumentOutOfRangeException>(() => Skewed.ControlPoint(3, 0, 0));
    }

    private static double Weight(int degree, int k, double t)
    {
        double weight = 1;
        for (int i = 1; i <= k; i++)
        {
            weight *= t * (degree - k + i) / i;
        }

        return weight * Math.Pow(1 - t, degree - k);
    }

    private Vector3[] Random(FreeFormLattice lattice, double size)
    {
        var offsets = new Vector3[lattice.Offsets.Length];
        for (int i = 0; i < offsets.Length; i++)
        {
            offsets[i] = Any(size);
        }

        return offsets;
    }

    private Vector3 Any(double size) => new((float)stream.Uniform(-size, size), (float)stream.Uniform(-size, size), (float)stream.Uniform(-size, size));

    private Vector3 Inside(FreeFormLattice lattice) =>
        lattice.Origin + (lattice.AxisS * (float)stream.Uniform(0.001, 0.999)) + (lattice.AxisT * (float)stream.Uniform(0.001, 0.999)) + (lattice.AxisU * (float)stream.Uniform(0.001, 0.999));

    private static void Close(Vector3 expected, Vector3 actual, float tolerance = 1e-6f) =>
        Assert.True(Vec.Distance(expected, actual) <= tolerance, $"{actual}; expected {expected}");
}
