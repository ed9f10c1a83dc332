using System;
using System.Globalization;
using System.Numerics;

namespace CreatureGen.Lattices;

/// <summary>Displaces a lattice slice by slice along U: each slice is widened, heightened and set apart from the one before it.</summary>
/// <remarks>
/// Scaling the slices' own places along U would let them pass one another and turn the ends inside out; so each keeps the place of the slice before it
/// and adds its own step, and every point stays behind those it was behind. The whole may grow longer or shorter.
/// </remarks>
internal static class SliceScaling
{
    /// <summary>The places of the slices along U in units of its length: 0 for the first, and each further one 1/n times its length factor beyond the one before it.</summary>
    /// <param name="lengths">One positive finite factor for each of the n + 1 slices, at least 2; the first has no slice before it and does not count.</param>
    /// <param name="positions">Filled; as long as <paramref name="lengths"/>.</param>
    /// <exception cref="ArgumentException">A factor is not positive and finite, or the lengths of the spans differ or are less than 2.</exception>
    public static void Positions(ReadOnlySpan<double> lengths, Span<double> positions)
    {
        CheckCount(lengths.Length, positions.Length, nameof(positions));
        CheckFactors(lengths, nameof(lengths));
        int degree = lengths.Length - 1;
        positions[0] = 0;
        for (int k = 1; k <= degree; k++)
        {
            positions[k] = positions[k - 1] + (lengths[k] / degree);
        }
    }

    /// <summary>The lattice with its slices scaled about the middle of S and T, and stepped along U.</summary>
    /// <param name="lattice">Gives the axes and degrees; its offsets are replaced.</param>
    /// <param name="widths">Factor on each of the n + 1 slices along S, positive.</param>
    /// <param name="heights">Factor along T, positive.</param>
    /// <param name="lengths">Factor on the step from the slice before, as in <see cref="Positions"/>.</param>
    /// <exception cref="ArgumentException">A factor is not positive and finite, or there is not one for each slice.</exception>
    public static FreeFormLattice Scale(FreeFormLattice lattice, ReadOnlySpan<double> widths, ReadOnlySpan<double> heights, ReadOnlySpan<double> lengths)
    {
        if (lattice is null)
        {
            throw new ArgumentNullException(nameof(lattice));
        }

        int slices = lattice.DegreeU + 1;
        CheckCount(slices, widths.Length, nameof(widths));
        CheckCount(slices, heights.Length, nameof(heights));
        CheckCount(slices, lengths.Length, nameof(lengths));
        CheckFactors(widths, nameof(widths));
        CheckFactors(heights, nameof(heights));
        Span<double> positions = stackalloc double[FreeFormLattice.MaxDegree + 1];
        positions = positions.Slice(0, slices);
        Positions(lengths, positions);

        Vector3 s = lattice.AxisS;
        Vector3 t = lattice.AxisT;
        Vector3 u = lattice.AxisU;
        var offsets = new Vector3[lattice.Offsets.Length];
        for (int k = 0; k < slices; k++)
        {
            double along = positions[k] - ((double)k / lattice.DegreeU);
            for (int j = 0; j <= lattice.DegreeT; j++)
            {
                double up = (heights[k] - 1) * (((double)j / lattice.DegreeT) - 0.5);
                for (int i = 0; i <= lattice.DegreeS; i++)
                {
                    double across = (widths[k] - 1) * (((double)i / lattice.DegreeS) - 0.5);
                    offsets[lattice.IndexOf(i, j, k)] = new Vector3(
                        (float)((across * s.X) + (up * t.X) + (along * u.X)),
                        (float)((across * s.Y) + (up * t.Y) + (along * u.Y)),
                        (float)((across * s.Z) + (up * t.Z) + (along * u.Z)));
                }
            }
        }

        return lattice.WithOffsets(offsets);
    }

    internal static void CheckCount(int slices, int count, string name)
    {
        if (slices < 2 || count != slices)
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "{0} for {1} slices; expected one for each of at least 2 slices", count, slices), name);
        }
    }

    internal static void CheckFactors(ReadOnlySpan<double> factors, string name)
    {
        for (int k = 0; k < factors.Length; k++)
        {
            if (!(factors[k] > 0 && factors[k] <= double.MaxValue))
            {
                throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "{0}[{1}] = {2:R}; expected a positive finite factor", name, k, factors[k]), name);
            }
        }
    }
}
