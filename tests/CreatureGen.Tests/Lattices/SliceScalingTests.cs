using System;
using System.Numerics;
using CreatureGen.Lattices;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Lattices;

public sealed class SliceScalingTests
{
    private const int Slices = 11;
    private const int Rings = 55;

    // A box about the axis from (0, 0, −0.4) to (0, 0, 0.6).
    private static readonly FreeFormLattice Box = new(new Vector3(-0.3f, -0.4f, -0.4f), Vector3.UnitX * 0.6f, Vector3.UnitY * 0.8f, Vector3.UnitZ);

    private readonly RandomStream stream = new(91);

    [Fact]
    public void Factors_of_one_leave_everything_where_it_is()
    {
        double[] ones = Filled(1);
        FreeFormLattice lattice = SliceScaling.Scale(Box, ones, ones, ones);
        for (int i = 0; i < 500; i++)
        {
            var p = new Vector3((float)stream.Uniform(-0.3, 0.3), (float)stream.Uniform(-0.4, 0.4), (float)stream.Uniform(-0.4, 0.6));
            Assert.True(Vec.Distance(p, lattice.Deform(p)) <= 1e-6f);
        }

        double[] t = Even(Rings);
        Rung(ones, ones, ones, t, out double[] width, out double[] height, out double[] position);
        for (int i = 0; i < Rings; i++)
        {
            Assert.Equal(1, width[i], 1e-14);
            Assert.Equal(1, height[i], 1e-14);
            Assert.Equal(t[i], position[i], 1e-14);
        }
    }

    [Fact]
    public void Each_slice_adds_its_own_step_to_the_place_of_the_slice_before()
    {
        var positions = new double[5];
        SliceScaling.Positions([99, 1, 2, 0.5, 4], positions);
        Assert.Equal([0, 0.25, 0.75, 0.875, 1.875], positions);
    }

    [Fact]
    public void The_step_of_the_first_slice_does_not_count()
    {
        double[] ones = Filled(1);
        double[] other = Filled(1);
        other[0] = 2.5;
        Rung(ones, ones, ones, Even(Rings), out _, out _, out double[] position);
        Rung(ones, ones, other, Even(Rings), out _, out _, out double[] same);
        Assert.Equal(position, same);
    }

    [Fact]
    public void Equal_factors_scale_the_body_as_a_whole()
    {
        Rung(Filled(1.5), Filled(0.5), Filled(2), Even(Rings), out double[] width, out double[] height, out double[] position);
        for (int i = 0; i < Rings; i++)
        {
            Assert.Equal(1.5, width[i], 1e-14);
            Assert.Equal(0.5, height[i], 1e-14);
            Assert.Equal(2 * i / (Rings - 1.0), position[i], 1e-14);
        }
    }

    [Fact]
    public void One_wide_slice_widens_rings_by_its_binomial_weights()
    {
        double[] widths = Filled(1);
        widths[5] = 2;
        Rung(widths, Filled(1), Filled(1), [0, 0.5, 1], out double[] width, out double[] height, out _);
        Assert.Equal(1, width[0], 1e-15);
        Assert.Equal(1 + (252.0 / 1024), width[1], 1e-15);
        Assert.Equal(1, width[2], 1e-15);
        Assert.Equal(1, height[1], 1e-15);
    }

    [Fact]
    public void Control_points_keep_to_their_slice_and_go_to_its_place_and_size()
    {
        Draw(out double[] widths, out double[] heights, out double[] lengths);
        FreeFormLattice lattice = SliceScaling.Scale(Box, widths, heights, lengths);
        var positions = new double[Slices];
        SliceScaling.Positions(lengths, positions);
        for (int k = 0; k < Slices; k++)
        {
            for (int j = 0; j <= 2; j++)
            {
                for (int i = 0; i <= 2; i++)
                {
                    var expected = new Vector3((float)((i - 1) * 0.3 * widths[k]), (float)((j - 1) * 0.4 * heights[k]), (float)(positions[k] - 0.4));
                    Assert.True(Vec.Distance(expected, lattice.ControlPoint(i, j, k)) <= 1e-6f);
                }
            }
        }
    }

    [Fact]
    public void The_rings_path_and_the_lattice_agree_on_points_of_rings()
    {
        double worst = 0;
        for (int trial = 0; trial < 300; trial++)
        {
            Draw(out double[] widths, out double[] heights, out double[] lengths);
            FreeFormLattice lattice = SliceScaling.Scale(Box, widths, heights, lengths);
            double[] t = Even(Rings);
            Rung(widths, heights, lengths, t, out double[] width, out double[] height, out double[] position);
            for (int ring = 0; ring < Rings; ring++)
            {
                double x = stream.Uniform(-0.3, 0.3);
                double y = stream.Uniform(-0.4, 0.4);
                var expected = new Vector3((float)(x * width[ring]), (float)(y * height[ring]), (float)(position[ring] - 0.4));
                Vector3 actual = lattice.Deform(new Vector3((float)x, (float)y, (float)(t[ring] - 0.4)));
                worst = Math.Max(worst, Vec.Distance(expected, actual));
            }
        }

        Assert.InRange(worst, 0, 1e-6);
    }

    [Fact]
    public void They_agree_in_a_turned_and_moved_lattice_of_other_degrees_too()
    {
        Quaternion turn = Rotation.FromAxisAngle(Vec.Normalize(new Vector3(1, -2, 0.5f)), 2);
        Vector3 s = Rotation.Rotate(turn, Vector3.UnitX) * 0.6f;
        Vector3 t = Rotation.Rotate(turn, Vector3.UnitY) * 0.8f;
        Vector3 u = Rotation.Rotate(turn, Vector3.UnitZ);
        var centre = new Vector3(0.2f, 0.1f, -0.3f);
        var rest = new FreeFormLattice(centre - (s / 2) - (t / 2), s, t, u, 1, 3, 6);
        for (int trial = 0; trial < 100; trial++)
        {
            Draw(out double[] widths, out double[] heights, out double[] lengths);
            Array.Resize(ref widths, 7);
            Array.Resize(ref heights, 7);
            Array.Resize(ref lengths, 7);
            FreeFormLattice lattice = SliceScaling.Scale(rest, widths, heights, lengths);
            double[] at = [stream.Uniform()];
            Rung(widths, heights, lengths, at, out double[] width, out double[] height, out double[] position);
            float x = (float)stream.Uniform(-0.5, 0.5);
            float y = (float)stream.Uniform(-0.5, 0.5);
            Vector3 expected = centre + (s * (float)(x * width[0])) + (t * (float)(y * height[0])) + (u * (float)position[0]);
            Vector3 actual = lattice.Deform(centre + (s * x) + (t * y) + (u * (float)at[0]));
            Assert.True(Vec.Distance(expected, actual) <= 2e-6f);
        }
    }

    [Fact]
    public void Slices_of_any_factors_never_pass_one_another()
    {
        double[] t = Even(Rings);
        for (int trial = 0; trial < 5000; trial++)
        {
            Draw(out double[] widths, out double[] heights, out double[] lengths);
            Rung(widths, heights, lengths, t, out double[] width, out double[] height, out double[] position);
            Assert.Equal(0, position[0]);
            for (int ring = 0; ring < Rings; ring++)
            {
                Assert.InRange(width[ring], 0.2 - 1e-12, 3 + 1e-12);
                Assert.InRange(height[ring], 0.2 - 1e-12, 3 + 1e-12);

                // The shortest step is a fifth of a slice: no ring follows closer than that share of its own step.
                Assert.True(ring == 0 || position[ring] - position[ring - 1] > 0.199 / (Rings - 1), $"trial {trial}, ring {ring}");
            }
        }
    }

    [Fact]
    public void Points_of_a_scaled_lattice_keep_their_order_along_it()
    {
        for (int trial = 0; trial < 200; trial++)
        {
            Draw(out double[] widths, out double[] heights, out double[] lengths);
            FreeFormLattice lattice = SliceScaling.Scale(Box, widths, heights, lengths);
            float before = float.NegativeInfinity;
            for (int i = 0; i <= 40; i++)
            {
                float z = lattice.Deform(new Vector3((float)stream.Uniform(-0.3, 0.3), (float)stream.Uniform(-0.4, 0.4), (i / 40f) - 0.4f)).Z;
                Assert.True(z > before);
                before = z;
            }
        }
    }

    [Fact]
    public void The_order_of_slices_turned_round_turns_the_body_round()
    {
        Draw(out double[] widths, out double[] heights, out double[] lengths);
        double[] t = Even(65);
        Rung(widths, heights, lengths, t, out double[] width, out _, out double[] position);

        // Steps lie between slices, so those of the reversed body are shifted by one.
        double[] back = (double[])lengths.Clone();
        Array.Reverse(back, 1, Slices - 1);
        Array.Reverse(widths);
        Rung(widths, heights, back, t, out double[] turned, out _, out double[] place);
        for (int i = 0; i < t.Length; i++)
        {
            Assert.Equal(width[i], turned[64 - i], 1e-12);
            Assert.Equal(position[64] - position[i], place[64 - i], 1e-12);
        }
    }

    [Fact]
    public void Factors_and_places_without_meaning_are_refused_with_their_index()
    {
        double[] ones = Filled(1);
        double[] bad = Filled(1);
        bad[4] = -0.5;
        Assert.Contains("widths[4] = -0.5", Refused(() => SliceScaling.Scale(Box, bad, ones, ones)), StringComparison.Ordinal);
        Assert.Contains("heights[4]", Refused(() => SliceScaling.Scale(Box, ones, bad, ones)), StringComparison.Ordinal);
        Assert.Contains("lengths[4]", Refused(() => SliceScaling.Scale(Box, ones, ones, bad)), StringComparison.Ordinal);
        bad[4] = double.NaN;
        Assert.Contains("sliceWidths[4] = NaN", Refused(() => Rung(bad, ones, ones, [0.5], out _, out _, out _)), StringComparison.Ordinal);
        Assert.Contains("t[1]", Refused(() => Rung(ones, ones, ones, [0.5, 1.1], out _, out _, out _)), StringComparison.Ordinal);
        Assert.Contains("10 for 11 slices", Refused(() => SliceScaling.Scale(Box, new double[10], ones, ones)), StringComparison.Ordinal);
        Refused(() => Rung([1], [1], [1], [0], out _, out _, out _));
        Refused(() => RingLattice.Evaluate(ones, ones, ones, new double[3], new double[3], new double[2], new double[3]));
    }

    private static string Refused(Action action) => Assert.Throws<ArgumentException>(action).Message;

    private static void Rung(double[] widths, double[] heights, double[] lengths, double[] t, out double[] width, out double[] height, out double[] position)
    {
        width = new double[t.Length];
        height = new double[t.Length];
        position = new double[t.Length];
        RingLattice.Evaluate(widths, heights, lengths, t, width, height, position);
    }

    private static double[] Filled(double factor)
    {
        var factors = new double[Slices];
        Array.Fill(factors, factor);
        return factors;
    }

    private static double[] Even(int count)
    {
        var t = new double[count];
        for (int i = 0; i < count; i++)
        {
            t[i] = i / (count - 1.0);
        }

        return t;
    }

    private void Draw(out double[] widths, out double[] heights, out double[] lengths)
    {
        widths = new double[Slices];
        heights = new double[Slices];
        lengths = new double[Slices];
        for (int k = 0; k < Slices; k++)
        {
            widths[k] = stream.Uniform(0.2, 3);
            heights[k] = stream.Uniform(0.2, 3);
            lengths[k] = stream.Uniform(0.2, 3);
        }
    }
}
