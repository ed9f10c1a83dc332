using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The sections of the tail: stalks that taper, fins that spread, and fans of feathers.</summary>
internal static class TailShaper
{
    /// <summary>Greatest length of a fluke along the spine, in half of its span.</summary>
    internal const double LongestFluke = 0.9;

    /// <summary>The ring from which on an upright fin spreads.</summary>
    private const int FinFirst = 47;

    /// <summary>Greatest length of an upright fin along the spine, in its sizes; those of fish are up to 1.6 long. Spread over all of a long tail it is a funnel that ends sawn off; a lance is to be long.</summary>
    private const double LongestFin = 2.2;

    /// <summary>The ring from which on a fluke spreads.</summary>
    private const int FlukeFirst = 47;

    /// <summary>What is left of the thickness of a stalk where its fin opens that is longer than the fin.</summary>
    private const double StalkEnd = 0.55;

    // Half thickness of an upright fin and of a fluke at their rear edges, metres, and what a fluke has more before it, in half of its span, and how soon that runs out to the edge: a sheet is a thread from the side, a fluke that is thick up to its edge a cushion from behind.
    private const double FinThickness = 0.007;
    private const double FlukeEdge = 0.009;
    private const double FlukeFlesh = 0.085;
    private const double FlukeThins = 1.1;

    /// <summary>Half thickness of a fan of feathers over their quills, metres, and the ring from which on it runs out to an edge: as thick to its end it is sawn off.</summary>
    private const double Quills = 0.017;
    private const int FanThins = 48;

    // Half width of a small fan in its sizes, by which part of itself it is narrower for each metre of its size, and how late it opens: a narrow one is an apron from behind.
    private const double FanSpread = 2.4;
    private const double WideFan = 3;
    private const double FanOpening = 1.3;

    /// <summary>Gives the rings of the tail the sections of its style.</summary>
    /// <param name="tail">The end of the tail.</param>
    /// <param name="step">Metres along the spine from the ring before to each ring.</param>
    /// <param name="width">Half widths, metres.</param>
    /// <param name="top">Heights above the spine, metres.</param>
    /// <param name="bottom">Depths below the spine, metres.</param>
    public static void Shape(TailBlueprint tail, ReadOnlySpan<double> step, double[] width, double[] top, double[] bottom)
    {
        const int Start = StationRing.TailFirst;
        double width0 = width[Start];
        double top0 = top[Start];
        double bottom0 = bottom[Start];
        switch (tail.Style)
        {
            case TailStyle.Fork:
            case TailStyle.Fan:
            case TailStyle.Lance:
                for (int i = Start; i < BodyGrid.Rings; i++)
                {
                    double q = tail.Style == TailStyle.Lance ? Scalar.Smooth((i - FinFirst) / 7.0) : Opening(tail, step, i);
                    double stalk = tail.Style == TailStyle.Lance ? 1 : Stalk(step, i, FinFirst, LongestFin * tail.Size);
                    double flare = tail.Size * PortableMath.Pow(q, 1.3);
                    top[i] = Math.Max(0.03, (stalk * top0 * (1 - q)) + (flare * (1 + tail.Lobe)));
                    bottom[i] = Math.Max(0.03, (stalk * bottom0 * (1 - q)) + (0.95 * flare * (1 - tail.Lobe)));
                    width[i] = (stalk * width0 * PortableMath.Pow(1 - q, 1.5)) + FinThickness;
                }

                break;
            case TailStyle.Fluke:
                for (int i = Start; i < BodyGrid.Rings; i++)
                {
                    double longest = LongestFluke * tail.Size;
                    double opened = Opened(step, i, FlukeFirst, longest);
                    double q = Scalar.Smooth(opened);
                    double stalk = Stalk(step, i, FlukeFirst, longest);
                    double flesh = FlukeEdge + (FlukeFlesh * tail.Size * PortableMath.Pow(1 - opened, FlukeThins) * Scalar.Smooth(2 * opened));
                    width[i] = (stalk * width0 * (1 - q)) + (tail.Size * FlukeTail.WidthAt(opened, tail.Lobe));
                    top[i] = (stalk * top0 * PortableMath.Pow(1 - q, 1.3)) + flesh;
                    bottom[i] = (stalk * bottom0 * PortableMath.Pow(1 - q, 1.3)) + flesh;
                }

                break;
            case TailStyle.Feathers:
                for (int i = Start - 1; i < BodyGrid.Rings; i++)
                {
                    double q = Scalar.Smooth((i - 45) / 8.0);
                    width[i] = (width[i] * (1 - q)) + (FanSpread * tail.Size / (1 + (WideFan * tail.Size)) * PortableMath.Pow(q, FanOpening));
                    double vane = Scalar.Lerp(Quills, BodyShaper.ThinnestSection, Scalar.Smooth((i - FanThins) / (double)(BodyGrid.Rings - 1 - FanThins)));
                    top[i] = (top[i] * (1 - q)) + (vane * q);
                    bottom[i] = (bottom[i] * (1 - q)) + (vane * q);
                }

                break;
            default:
                if (TailTaper.Of(tail.Style) is TailTaper taper)
                {
                    Taper(taper, Math.Min(1, tail.Size), width, top, bottom);
                }
                else if (TailFin.Of(tail.Style) is TailFin fin)
                {
                    Spread(fin, tail, step, width, top, bottom);
                }

                break;
        }
    }

    /// <summary>Gives the tail from its root on the thickness of a form.</summary>
    private static void Taper(TailTaper form, double fraction, double[] width, double[] top, double[] bottom)
    {
        const int Last = BodyGrid.Rings - 1;
        (double width0, double height0) = Root(form, width, top, bottom);
        for (int i = StationRing.TorsoLast + 1; i <= Last; i++)
        {
            (double w, double h) = form.At((double)(i - StationRing.TorsoLast) / (Last - StationRing.TorsoLast));
            double bead = i % 2 == 1 ? 1 : 1 - form.Beads;
            double weight = fraction * Scalar.Smooth((i - StationRing.TorsoLast) / 3.0);
            width[i] = Math.Max(BodyShaper.ThinnestSection, Scalar.Lerp(width[i], w * bead * width0, weight));
            top[i] = Math.Max(BodyShaper.ThinnestSection, Scalar.Lerp(top[i], h * bead * height0, weight));
            bottom[i] = Math.Max(BodyShaper.ThinnestSection, Scalar.Lerp(bottom[i], h * bead * height0, weight));
        }
    }

    /// <summary>Half width and half height that a form is told in: those of the end of the rump; of a tail that leaves it thinner its own, or it would swell behind its root, as beads do.</summary>
    private static (double Width, double Height) Root(TailTaper form, double[] width, double[] top, double[] bottom)
    {
        const int Rump = StationRing.TorsoLast;
        const int First = StationRing.TailFirst;
        (double w, double h) = form.At((double)(First - Rump) / (BodyGrid.Rings - 1 - Rump));
        (double width0, double height0) = (width[Rump], (top[Rump] + bottom[Rump]) / 2);
        return form.Beads > 0 ? (width0, height0) : (Math.Min(width0, width[First] / w), Math.Min(height0, (top[First] + bottom[First]) / h / 2));
    }

    /// <summary>Spreads the end of the tail into an upright fin.</summary>
    private static void Spread(TailFin form, TailBlueprint tail, ReadOnlySpan<double> step, double[] width, double[] top, double[] bottom)
    {
        const int Start = StationRing.TailFirst;
        (double width0, double top0, double bottom0) = (width[Start], top[Start], bottom[Start]);
        for (int i = Start; i < BodyGrid.Rings; i++)
        {
            double q = Opening(tail, step, i);
            double stalk = Stalk(step, i, FinFirst, LongestFin * tail.Size);
            double flare = tail.Size * PortableMath.Pow(q, form.Spread);
            top[i] = Math.Max(0.03, (stalk * top0 * (1 - q)) + (form.Halves.Upper * flare * (1 + tail.Lobe)));
            bottom[i] = Math.Max(0.03, (stalk * bottom0 * (1 - q)) + (form.Halves.Lower * flare * (1 - tail.Lobe)));
            width[i] = (stalk * width0 * PortableMath.Pow(1 - q, 1.5)) + FinThickness;
        }
    }

    /// <summary>How far an upright fin has opened at a ring, 0 at the end of its stalk to 1 at its rear edge.</summary>
    private static double Opening(TailBlueprint tail, ReadOnlySpan<double> step, int ring)
    {
        double longest = LongestFin * tail.Size;
        return Scalar.Smooth(Behind(step, FinFirst) > longest ? Opened(step, ring, FinFirst, longest) : (ring - FinFirst) / 7.0);
    }

    /// <summary>Thickness of the stalk of a fin at a ring, in that of its root: one that is longer than the fin runs evenly to where that opens, and not to a thread before it.</summary>
    private static double Stalk(ReadOnlySpan<double> step, int ring, int first, double longest)
    {
        double behind = Behind(step, StationRing.TailFirst);
        double stalk = behind - Math.Min(Behind(step, first), longest);
        double along = stalk > 0 ? Math.Min(1, (behind - Behind(step, ring)) / stalk) : 1;
        return 1 - ((1 - StalkEnd) * along * Scalar.Clamp((Behind(step, first) / longest) - 1, 0, 1));
    }

    /// <summary>How far a ring is along a fin that ends with the tail, 0 before it to 1 at its end.</summary>
    private static double Opened(ReadOnlySpan<double> step, int ring, int first, double longest) =>
        Math.Max(0, 1 - (Behind(step, Math.Max(ring, first)) / Math.Min(Behind(step, first), longest)));

    /// <summary>Metres along the spine from a ring to the end of the tail.</summary>
    private static double Behind(ReadOnlySpan<double> step, int ring)
    {
        double length = 0;
        for (int i = ring + 1; i < BodyGrid.Rings; i++)
        {
            length += step[i];
        }

        return length;
    }
}
