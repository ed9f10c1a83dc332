using System;

namespace CreatureGen.Maths;

/// <content>Inverse circular functions.</content>
internal static partial class PortableMath
{
    // Minimax polynomial (Remez exchange) on 0..1/64 in the squared tangent: (atan t / t − 1) / t².
    private const double A0 = -0.3333333333333333;
    private const double A1 = 0.19999999999994475;
    private const double A2 = -0.14285714282656703;
    private const double A3 = 0.11111110308354398;
    private const double A4 = -0.09090796258948752;
    private const double A5 = 0.07683573506390964;
    private const double A6 = -0.06314356845794664;

    // Quotients below 2^−60 are their own angles.
    private const double TinyQuotient = 1.0 / (1L << 60);
    private const double LargeTerm = 1e270;
    private const double SmallTerm = 1e-120;
    private const double ToLess = 1.0 / ((double)(1L << 62) * (1L << 62));
    private const double ToMore = (double)(1L << 62) * (1L << 62) * (1L << 62) * (1L << 62) * (1L << 62) * (1L << 62) * (1L << 62) * (1L << 62);

    /// <summary>The angles whose tangents are 0/16, 1/16, … 16/16, and below them what they have beyond a double.</summary>
    private static readonly double[] AngleOfSixteenths =
    {
        0, 0.06241880999595735, 0.12435499454676144, 0.18534794999569476,
        0.24497866312686414, 0.3028848683749714, 0.35877067027057225, 0.4124104415973873,
        0.4636476090008061, 0.5123894603107377, 0.5585993153435624, 0.6022873461349642,
        0.6435011087932844, 0.6823165548747481, 0.7188299996216245, 0.7531512809621944,
        0.7853981633974483,
        0, -1.5490756308295046e-18, -3.1253241424539383e-18, 4.180692268843079e-18,
        1.0698755618734451e-17, -1.1010827903001369e-17, -2.4623815582638635e-17, -1.587652227770689e-17,
        2.2698777452961687e-17, -2.5462781472855804e-17, -5.4556305485916264e-18, 2.950430737228402e-17,
        1.5834785051444286e-17, 6.943223671560008e-18, -2.1478388444456983e-17, -2.4256934659182068e-17,
        3.061616997868383e-17,
    };

    /// <summary>Angle of the point (x, y), radians, −π..π, within 0.85 ulp.</summary>
    /// <remarks>Zeros keep their signs as in IEEE 754: the angle of (−0, +0) is π, that of (−0, −0) is −π; infinities count as equal to each other.</remarks>
    public static double Atan2(double y, double x)
    {
        if (double.IsNaN(x) || double.IsNaN(y))
        {
            return double.NaN;
        }

        bool below = BitConverter.DoubleToInt64Bits(y) < 0;
        bool behind = BitConverter.DoubleToInt64Bits(x) < 0;
        double rise = Math.Abs(y);
        double run = Math.Abs(x);
        if (run > double.MaxValue)
        {
            rise = rise > double.MaxValue ? 1 : 0;
            run = 1;
        }
        else if (rise > double.MaxValue)
        {
            rise = 1;
            run = 0;
        }

        if (rise == 0 && run == 0)
        {
            run = 1;
        }

        double angle = AngleOf(rise, 0, run, 0, behind);
        return below ? -angle : angle;
    }

    /// <summary>Angle whose tangent is x, radians, −π/2..π/2, within 0.85 ulp; infinities give ±π/2.</summary>
    public static double Atan(double x)
    {
        double rise = Math.Abs(x);
        if (rise < TinyArgument || double.IsNaN(x))
        {
            return x;
        }

        double angle = rise > double.MaxValue ? Pi / 2 : AngleOf(rise, 0, 1, 0, false);
        return x < 0 ? -angle : angle;
    }

    /// <summary>Angle whose sine is x, radians, −π/2..π/2, within 0.85 ulp; NaN outside −1..1.</summary>
    public static double Asin(double x)
    {
        double rise = Math.Abs(x);
        if (!(rise <= 1))
        {
            return double.NaN;
        }

        if (rise < TinyArgument)
        {
            return x;
        }

        double run = OtherLeg(rise, out double rest);
        double angle = AngleOf(rise, 0, run, rest, false);
        return x < 0 ? -angle : angle;
    }

    /// <summary>Angle whose cosine is x, radians, 0..π, within 0.85 ulp; NaN outside −1..1.</summary>
    public static double Acos(double x)
    {
        double run = Math.Abs(x);
        if (!(run <= 1))
        {
            return double.NaN;
        }

        if (run < TinyQuotient)
        {
            return Pi / 2;
        }

        double rise = OtherLeg(run, out double rest);
        return AngleOf(rise, rest, run, 0, x < 0);
    }

    /// <summary>√(1 − a²) and its rest, a from 2^−60 to 1.</summary>
    private static double OtherLeg(double a, out double rest)
    {
        double square = ErrorFree.Square(a, out double squareRest);
        double left = ErrorFree.OrderedSum(1, -square, out double leftRest);
        left = ErrorFree.OrderedSum(left, leftRest - squareRest, out leftRest);
        if (left <= 0)
        {
            rest = 0;
            return 0;
        }

        double root = Math.Sqrt(left);
        double rootSquare = ErrorFree.Square(root, out double rootRest);
        rest = ((left - rootSquare) - rootRest + leftRest) / (2 * root);
        return root;
    }

    /// <summary>Angle 0..π of the point (±run, rise), each with its small rest; both finite and not negative, not both zero.</summary>
    private static double AngleOf(double rise, double riseRest, double run, double runRest, bool behind)
    {
        bool steep = rise > run;
        double high = steep
            ? FlatAngle(run, runRest, rise, riseRest, out double low)
            : FlatAngle(rise, riseRest, run, runRest, out low);
        if (!steep)
        {
            if (!behind)
            {
                return high + low;
            }

            double sum = ErrorFree.OrderedSum(Pi, -high, out double rest);
            return sum + (rest + (PiRest - low));
        }
        else
        {
            double sum = ErrorFree.OrderedSum(Pi / 2, behind ? high : -high, out double rest);
            return sum + (rest + ((PiRest / 2) + (behind ? low : -low)));
        }
    }

    /// <summary>Angle 0..π/4 whose tangent is a/b, a ≤ b, as a number and a smaller one.</summary>
    /// <remarks>The nearest sixteenth c is taken from the quotient q by atan q = atan c + atan((q − c) / (1 + q·c)); a polynomial gives the rest.</remarks>
    private static double FlatAngle(double a, double aRest, double b, double bRest, out double low)
    {
        double q = a / b;
        if (q < TinyQuotient)
        {
            low = 0;
            return q;
        }

        if (b > LargeTerm)
        {
            a *= ToLess;
            b *= ToLess;
        }
        else if (b < SmallTerm)
        {
            a *= ToMore;
            b *= ToMore;
            q = a / b;
        }

        double product = ErrorFree.Product(q, b, out double productRest);
        double qRest = ((((a - product) - productRest) + aRest) - (q * bRest)) / b;
        if (q < 0.125)
        {
            low = qRest + (q * AngleSeries(q));
            return q;
        }

        int sixteenths = (int)((q * 16) + 0.5);
        double c = sixteenths * 0.0625;
        double t = ((q - c) + qRest) / (1 + (q * c));
        low = AngleOfSixteenths[sixteenths + 17] + (t + (t * AngleSeries(t)));
        return AngleOfSixteenths[sixteenths];
    }

    /// <summary>atan t / t − 1, |t| up to 1/8.</summary>
    private static double AngleSeries(double t)
    {
        double z = t * t;
        double w = z * z;
        return z * ((A0 + (z * A1)) + (w * ((A2 + (z * A3)) + (w * ((A4 + (z * A5)) + (w * A6))))));
    }
}
