using System;
using System.Globalization;
using CreatureGen.Maths;

namespace CreatureGen.Lattices;

/// <summary>What <see cref="SliceScaling"/> does to the rings of a body about the lattice's axis, without a lattice.</summary>
/// <remarks>
/// Across a slice the scaling is linear, and Bernstein weights of any degree give linear functions back. So a whole ring at u is scaled in width by
/// Σ B(n, k)(u) · width(k), in height by the like sum, and moved along the axis to Σ B(n, k)(u) · position(k).
/// </remarks>
internal static class RingLattice
{
    /// <summary>The factors and places of rings.</summary>
    /// <param name="sliceWidths">Width factor of each of the n + 1 slices (11 for a body), positive.</param>
    /// <param name="sliceHeights">Height factor of each slice, positive.</param>
    /// <param name="sliceLengths">Factor on each slice's step from the one before it, positive; the first has none and does not count.</param>
    /// <param name="t">Undeformed places of the rings in units of the undeformed length, 0..1.</param>
    /// <param name="widthFactor">Filled with each ring's width factor.</param>
    /// <param name="heightFactor">Filled with each ring's height factor.</param>
    /// <param name="position">Filled with each ring's place in units of the undeformed length: 0 at t = 0, and rising with t.</param>
    /// <exception cref="ArgumentException">The counts of slices or of rings differ, a factor is not positive and finite, or a place is outside 0..1.</exception>
    public static void Evaluate(
        ReadOnlySpan<double> sliceWidths,
        ReadOnlySpan<double> sliceHeights,
        ReadOnlySpan<double> sliceLengths,
        ReadOnlySpan<double> t,
        Span<double> widthFactor,
        Span<double> heightFactor,
        Span<double> position)
    {
        int slices = sliceWidths.Length;
        if (slices > FreeFormLattice.MaxDegree + 1)
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "{0} slices; expected at most {1}", slices, FreeFormLattice.MaxDegree + 1), nameof(sliceWidths));
        }

        SliceScaling.CheckCount(slices, sliceHeights.Length, nameof(sliceHeights));
        SliceScaling.CheckCount(slices, sliceLengths.Length, nameof(sliceLengths));
        SliceScaling.CheckFactors(sliceWidths, nameof(sliceWidths));
        SliceScaling.CheckFactors(sliceHeights, nameof(sliceHeights));
        if (widthFactor.Length != t.Length || heightFactor.Length != t.Length || position.Length != t.Length)
        {
            throw new ArgumentException(
                string.Format(CultureInfo.InvariantCulture, "room for {0} widths, {1} heights and {2} positions; expected {3} of each", widthFactor.Length, heightFactor.Length, position.Length, t.Length),
                nameof(t));
        }

        for (int ring = 0; ring < t.Length; ring++)
        {
            if (!(t[ring] >= 0 && t[ring] <= 1))
            {
                throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "t[{0}] = {1:R}; expected 0..1", ring, t[ring]), nameof(t));
            }
        }

        Span<double> positions = stackalloc double[slices];
        Span<double> weights = stackalloc double[slices];
        SliceScaling.Positions(sliceLengths, positions);
        int first = 0;
#if NET
        if (FourVectors.Pay)
        {
            first = FourRings.Evaluate(sliceWidths, sliceHeights, positions, t, widthFactor, heightFactor, position);
        }
#endif
        for (int ring = first; ring < t.Length; ring++)
        {
            Bernstein.Evaluate(t[ring], weights);
            double width = 0;
            double height = 0;
            double place = 0;
            for (int k = 0; k < slices; k++)
            {
                width += weights[k] * sliceWidths[k];
                height += weights[k] * sliceHeights[k];
                place += weights[k] * positions[k];
            }

            widthFactor[ring] = width;
            heightFactor[ring] = height;
            position[ring] = place;
        }
    }
}
