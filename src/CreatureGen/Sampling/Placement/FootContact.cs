using System;

namespace CreatureGen.Sampling.Placement;

/// <summary>The sole of a left foot on the ground, a rectangle; the right foot is its mirror image. Metres.</summary>
internal readonly record struct FootContact
{
    /// <summary>Describes a sole.</summary>
    /// <param name="x">Centre, to the left of the body's plane.</param>
    /// <param name="z">Centre, along the ground.</param>
    /// <param name="halfWidth">Half width.</param>
    /// <param name="heel">Length behind the centre.</param>
    /// <param name="toe">Length before the centre.</param>
    /// <exception cref="ArgumentOutOfRangeException">The sole has no width or no length, or a number is not finite.</exception>
    public FootContact(double x, double z, double halfWidth, double heel, double toe)
    {
        double sum = x + z + halfWidth + heel + toe;
        if (!(halfWidth > 0 && heel >= 0 && toe >= 0 && heel + toe > 0) || double.IsNaN(sum) || double.IsInfinity(sum))
        {
            throw new ArgumentOutOfRangeException(nameof(halfWidth), FormattableString.Invariant($"sole at ({x}, {z}) of half width {halfWidth}, heel {heel}, toe {toe}; expected finite numbers, a positive width and a positive length"));
        }

        X = x;
        Z = z;
        HalfWidth = halfWidth;
        Heel = heel;
        Toe = toe;
    }

    /// <summary>Centre, to the left of the body's plane.</summary>
    public double X { get; }

    /// <summary>Centre, along the ground.</summary>
    public double Z { get; }

    /// <summary>Half width.</summary>
    public double HalfWidth { get; }

    /// <summary>Length behind the centre.</summary>
    public double Heel { get; }

    /// <summary>Length before the centre.</summary>
    public double Toe { get; }

    /// <summary>The same foot set forward by <paramref name="metres"/>.</summary>
    public FootContact Shifted(double metres) => new(X, Z + metres, HalfWidth, Heel, Toe);

    /// <summary>The same foot larger by a factor.</summary>
    public FootContact Grown(double factor) => new(X, Z, HalfWidth * factor, Heel * factor, Toe * factor);
}
