using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>Smooth curves through numbers at the stations of a body, at its rings.</summary>
/// <remarks>What <see cref="MonotoneCubic"/> gives, in half of the time: where rings lie between stations never changes, so it is divided out once.</remarks>
internal static class RingCurve
{
    private static readonly double[] knots = Array.ConvertAll(BodyGrid.StationRings.ToArray(), r => (double)r);
    private static readonly Place[] places = PlacesOfRings();

    /// <summary>Fills the rings from the stations.</summary>
    /// <param name="stations">A number for each station.</param>
    /// <param name="rings">A number for each ring.</param>
    public static void Through(ReadOnlySpan<double> stations, Span<double> rings)
    {
        Span<double> slopes = stackalloc double[BodyGrid.StationCount];
        MonotoneCubic.Slopes(knots, stations, slopes);
        rings = rings.Slice(0, places.Length);
        for (int i = 0; i < places.Length; i++)
        {
            ref readonly Place p = ref places[i];
            rings[i] = (stations[p.Interval] * p.U * p.U * p.Before)
                + (stations[p.Interval + 1] * p.T * p.T * p.Behind)
                + (slopes[p.Interval] * p.Length * p.T * p.U * p.U)
                - (slopes[p.Interval + 1] * p.Length * p.T * p.T * p.U);
        }
    }

    private static Place[] PlacesOfRings()
    {
        var places = new Place[BodyGrid.Rings];
        int interval = 0;
        for (int i = 0; i < places.Length; i++)
        {
            while (interval < BodyGrid.StationCount - 2 && i >= BodyGrid.StationRings[interval + 1])
            {
                interval++;
            }

            places[i] = new Place(interval, knots[interval + 1] - knots[interval], i - knots[interval]);
        }

        return places;
    }

    /// <summary>Where a ring lies between two stations, and what the cubics of Hermite are made of there.</summary>
    private readonly struct Place
    {
        public Place(int interval, double length, double from)
        {
            Interval = interval;
            Length = length;
            T = from / length;
            U = 1 - T;
            Before = 1 + (2 * T);
            Behind = 3 - (2 * T);
        }

        public int Interval { get; }

        public double Length { get; }

        public double T { get; }

        public double U { get; }

        public double Before { get; }

        public double Behind { get; }
    }
}
