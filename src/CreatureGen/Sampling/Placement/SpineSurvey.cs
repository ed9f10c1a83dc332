using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>Measures a torso for the attachment rules from the sections of a body.</summary>
internal static class SpineSurvey
{
    /// <summary>Bones of a torso when nothing else is asked for: one for every two rings.</summary>
    public const int TorsoBones = 11;

    /// <summary>Distance of the centroid of a half ellipse from its straight side, in half axes: 4 / 3π.</summary>
    private const double HalfEllipse = 0.4244131815783876;

    /// <summary>Measures the torso, rings 22 to 44, as 11 bones.</summary>
    /// <inheritdoc cref="Measure(ReadOnlySpan{double}, ReadOnlySpan{double}, ReadOnlySpan{double}, ReadOnlySpan{double}, ReadOnlySpan{double}, int, int, int)"/>
    public static SpineMeasure Measure(ReadOnlySpan<double> y, ReadOnlySpan<double> z, ReadOnlySpan<double> width, ReadOnlySpan<double> top, ReadOnlySpan<double> bottom) =>
        Measure(y, z, width, top, bottom, StationRing.NeckBase, StationRing.TorsoLast, TorsoBones);

    /// <summary>
    /// Cuts the rings from <paramref name="firstRing"/> to <paramref name="lastRing"/> into bones of equally many rings. The body's length is that of these bones,
    /// its height that of the spine at the middle of that length, where the centre bone is; the centre of mass is that of all rings.
    /// </summary>
    /// <param name="y">Height of the spine per ring, 55 numbers, metres at scale 1.</param>
    /// <param name="z">Place of the spine along the ground per ring, front greatest.</param>
    /// <param name="width">Half width of the section per ring.</param>
    /// <param name="top">Height of the section above the spine per ring.</param>
    /// <param name="bottom">Depth of the section below the spine per ring.</param>
    /// <param name="firstRing">Front end of the torso.</param>
    /// <param name="lastRing">Rear end of the torso.</param>
    /// <param name="bones">Number of bones, at least 2.</param>
    /// <exception cref="ArgumentException">An array has not 55 numbers, or the rings or the number of bones are out of range.</exception>
    public static SpineMeasure Measure(
        ReadOnlySpan<double> y,
        ReadOnlySpan<double> z,
        ReadOnlySpan<double> width,
        ReadOnlySpan<double> top,
        ReadOnlySpan<double> bottom,
        int firstRing,
        int lastRing,
        int bones)
    {
        if (y.Length != BodyGrid.Rings || z.Length != y.Length || width.Length != y.Length || top.Length != y.Length || bottom.Length != y.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{y.Length}, {z.Length}, {width.Length}, {top.Length} and {bottom.Length} numbers per ring; expected {BodyGrid.Rings} of each"));
        }

        if (firstRing < 0 || lastRing >= BodyGrid.Rings || firstRing >= lastRing)
        {
            throw new ArgumentException(FormattableString.Invariant($"rings {firstRing} to {lastRing}; expected ascending rings within 0..{BodyGrid.Rings - 1}"));
        }

        if (bones < 2)
        {
            throw new ArgumentOutOfRangeException(nameof(bones), bones, "expected at least 2 bones");
        }

        Span<double> arc = stackalloc double[BodyGrid.Rings];
        arc[0] = 0;
        for (int i = 1; i < arc.Length; i++)
        {
            double dy = y[i] - y[i - 1];
            double dz = z[i] - z[i - 1];
            arc[i] = arc[i - 1] + Math.Sqrt((dy * dy) + (dz * dz));
        }

        double ringsPerBone = (lastRing - firstRing) / (double)bones;
        double length = arc[lastRing] - arc[firstRing];
        double middle = arc[firstRing] + (0.5 * length);
        var measured = new SpineBone[bones];
        int centre = 0;
        double nearest = double.MaxValue;
        for (int i = 0; i < bones; i++)
        {
            double from = firstRing + (i * ringsPerBone);
            double ring = from + (0.5 * ringsPerBone);
            measured[i] = new SpineBone(
                i,
                ring,
                2 * At(width, ring),
                At(arc, from + ringsPerBone) - At(arc, from),
                At(y, ring),
                At(top, ring) + At(bottom, ring),
                At(z, ring));
            double off = Math.Abs(At(arc, ring) - middle);
            if (off < nearest)
            {
                nearest = off;
                centre = i;
            }
        }

        return new SpineMeasure(measured, length, measured[centre].Height, centre, CentreOfMass(y, z, width, top, bottom, arc));
    }

    /// <summary>Centre of mass of slices of equal density, each of two half ellipses, one above and one below the spine.</summary>
    private static SagittalPoint CentreOfMass(
        ReadOnlySpan<double> y,
        ReadOnlySpan<double> z,
        ReadOnlySpan<double> width,
        ReadOnlySpan<double> top,
        ReadOnlySpan<double> bottom,
        ReadOnlySpan<double> arc)
    {
        double mass = 0;
        double momentY = 0;
        double momentZ = 0;
        for (int i = 0; i < arc.Length; i++)
        {
            double thickness = 0.5 * (arc[Math.Min(i + 1, arc.Length - 1)] - arc[Math.Max(i - 1, 0)]);
            double slice = PortableMath.Pi * width[i] * 0.5 * (top[i] + bottom[i]) * thickness;
            double ahead = z[Math.Max(i - 1, 0)] - z[Math.Min(i + 1, arc.Length - 1)];
            double above = y[Math.Max(i - 1, 0)] - y[Math.Min(i + 1, arc.Length - 1)];
            double along = Math.Sqrt((ahead * ahead) + (above * above));
            double offset = along > 0 ? HalfEllipse * (top[i] - bottom[i]) / along : 0;
            mass += slice;
            momentY += slice * (y[i] + (offset * ahead));
            momentZ += slice * (z[i] - (offset * above));
        }

        if (!(mass > 0))
        {
            throw new ArgumentException("the body has no volume; expected positive widths, heights and lengths");
        }

        return new SagittalPoint(momentY / mass, momentZ / mass);
    }

    private static double At(ReadOnlySpan<double> values, double ring)
    {
        int i = (int)ring;
        return i >= values.Length - 1 ? values[values.Length - 1] : Scalar.Lerp(values[i], values[i + 1], ring - i);
    }
}
