using System;

namespace CreatureGen.Maths;

/// <summary>Bernstein polynomials B(n, k)(t) = n!/(k!(n − k)!) · tᵏ · (1 − t)ⁿ⁻ᵏ: the weights of the control points of a Bézier curve.</summary>
/// <remarks>They add up to 1 for every t, are not negative for t in 0..1, and Σ (k/n) · B(n, k)(t) = t. Based on: G. Farin, "Curves and Surfaces for CAGD" (2002), chapter 5.</remarks>
internal static class Bernstein
{
    /// <summary>The n + 1 polynomials of degree n at <paramref name="t"/>.</summary>
    /// <param name="t">Any finite number; outside 0..1 weights are negative and rounding errors grow with its n-th power.</param>
    /// <param name="basis">Filled; its length is n + 1, at least 1.</param>
    /// <exception cref="ArgumentException"><paramref name="basis"/> is empty.</exception>
    /// <remarks>Raised degree by degree with B(n, k) = (1 − t) · B(n − 1, k) + t · B(n − 1, k − 1); all sums are of numbers of one sign for t in 0..1, so each weight keeps its relative precision.</remarks>
    public static void Evaluate(double t, Span<double> basis)
    {
        if (basis.IsEmpty)
        {
            throw new ArgumentException("the basis has no room; expected degree + 1 places", nameof(basis));
        }

        double u = 1 - t;
        basis[0] = 1;
        for (int degree = 1; degree < basis.Length; degree++)
        {
            double before = basis[0];
            basis[0] = u * before;
            for (int k = 1; k < degree; k++)
            {
                double here = basis[k];
                basis[k] = (u * here) + (t * before);
                before = here;
            }

            basis[degree] = t * before;
        }
    }
}
