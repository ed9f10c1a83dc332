using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;

namespace CreatureGen.Motion.Swimming;

/// <summary>The wave of a swimmer's axis at the points where its bones meet, ready to be evaluated at any phase.</summary>
/// <remarks>
/// Every displacement is a sine of the phase, y = c·cos 2πφ + s·sin 2πφ, and stays one when the head is steadied and the tail fin lags: all of it is worked out once.
/// A bone whose ends are displaced by y₀ and y₁ heads by asin((y₀ − y₁)/length): its ends are then exactly on the curve.
/// </remarks>
internal sealed class SwimWave
{
    /// <summary>Share of a cycle by which a tail fin that bends is behind.</summary>
    private const double FinLag = 0.06;

    /// <summary>Share of that in the last bone.</summary>
    private const double FinFraction = 0.65;

    /// <summary>Steepest heading of the tail fin at cruise, as a sine.</summary>
    private const double SteepestFin = 0.62;

    /// <summary>The same of a tail without a fin.</summary>
    private const double SteepestTail = 0.75;

    /// <summary>Steepest heading of a bone, as a sine: more than the widest beat comes to.</summary>
    public const double Steepest = 0.9;

    private readonly double[] cosines;
    private readonly double[] sines;
    private readonly double[] lengths;
    private double meanCosine;
    private double meanSine;

    /// <summary>Works the wave out for a body.</summary>
    public SwimWave(AxialChain chain, SwimStyle style, SwimKinematics kinematics)
    {
        int count = chain.Count;
        cosines = new double[count + 1];
        sines = new double[count + 1];
        lengths = new double[count];
        double length = chain.Length;
        double[] along = new double[count + 1];
        for (int p = 0; p <= count; p++)
        {
            float z = p == count ? chain.TailTip.Z : chain.Bones[p].Front.Z;
            along[p] = (chain.Nose.Z - z) / length;
        }

        for (int b = 0; b < count; b++)
        {
            lengths[b] = Math.Max((along[b + 1] - along[b]) * length, 1e-3 * length);
        }

        Fill(style, kinematics.Wavelength, along, 0, cosines, sines);
        LagTail(style, kinematics.Wavelength, along);

        // The head is stiff and steadied; the neck of those that have one shares in it.
        cosines[0] = cosines[1] + (kinematics.HeadFraction * (cosines[0] - cosines[1]));
        sines[0] = sines[1] + (kinematics.HeadFraction * (sines[0] - sines[1]));
        SpreadTail(count, kinematics.TailSweep * length / 2, style == SwimStyle.Anguilliform ? SteepestTail : SteepestFin);
        for (int b = 0; b < count; b++)
        {
            meanCosine += chain.Bones[b].Mass * 0.5 * (cosines[b] + cosines[b + 1]);
            meanSine += chain.Bones[b].Mass * 0.5 * (sines[b] + sines[b + 1]);
        }
    }

    /// <summary>Half the way of the tail's tip across, metres, at amplitude 1.</summary>
    public double TailReach => Reach(cosines.Length - 1);

    /// <summary>Half the way of the nose across, metres, at amplitude 1.</summary>
    public double NoseReach => Reach(0);

    /// <summary>Displacement of a point at amplitude 1, metres.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Displacement(int point, double cosine, double sine) => (cosines[point] * cosine) + (sines[point] * sine);

    /// <summary>Displacement of the centre of mass at amplitude 1, metres.</summary>
    public double Mean(double cosine, double sine) => (meanCosine * cosine) + (meanSine * sine);

    /// <summary>Heading of a bone, radians.</summary>
    /// <param name="bone">Nose to tail.</param>
    /// <param name="amplitude">1 at cruise.</param>
    /// <param name="cosine">Of 2π times the phase.</param>
    /// <param name="sine">Of 2π times the phase.</param>
    public double Heading(int bone, double amplitude, double cosine, double sine)
    {
        double across = amplitude * (Displacement(bone, cosine, sine) - Displacement(bone + 1, cosine, sine)) / lengths[bone];
        return PortableMath.Asin(Scalar.Clamp(across, -Steepest, Steepest));
    }

    /// <summary>Greatest sine of a bone's heading over a cycle at amplitude 1.</summary>
    public double Steepness(int bone)
    {
        double c = Slope(cosines, bone);
        double s = Slope(sines, bone);
        return Math.Max(Math.Sqrt((c * c) + (s * s)), 1e-9);
    }

    /// <summary>Greatest change of heading from a bone to the next over a cycle, radians.</summary>
    public double Bend(int bone, double amplitude)
    {
        const int Samples = 32;
        double max = 0;
        for (int i = 0; i < Samples; i++)
        {
            // Half a cycle: the other half is its mirror image.
            PortableMath.SinCos(PortableMath.Pi * i / Samples, out double sine, out double cosine);
            max = Math.Max(max, Math.Abs(Heading(bone, amplitude, cosine, sine) - Heading(bone + 1, amplitude, cosine, sine)));
        }

        return max;
    }

    /// <summary>Makes the wave so many times as wide.</summary>
    public void Scale(double factor)
    {
        for (int p = 0; p < cosines.Length; p++)
        {
            cosines[p] *= factor;
            sines[p] *= factor;
        }

        meanCosine *= factor;
        meanSine *= factor;
    }

    /// <summary>Brings the tail's way across to its width. A tail fin that would stand steeper than water lets it is eased, and the rest widened for it.</summary>
    private void SpreadTail(int tip, double reach, double steepest)
    {
        for (int pass = 0; pass < 4; pass++)
        {
            Scale(reach / Reach(tip));
            double c = Slope(cosines, tip - 1);
            double s = Slope(sines, tip - 1);
            double ease = steepest / Math.Max(Math.Sqrt((c * c) + (s * s)), steepest);
            cosines[tip] = cosines[tip - 1] + (ease * (cosines[tip] - cosines[tip - 1]));
            sines[tip] = sines[tip - 1] + (ease * (sines[tip] - sines[tip - 1]));
        }

        Scale(reach / Reach(tip));
    }

    private static void Fill(SwimStyle style, double wavelength, double[] along, double lag, double[] cosines, double[] sines)
    {
        // sin(a − 2πφ) = sin a·cos 2πφ − cos a·sin 2πφ
        for (int p = 0; p < along.Length; p++)
        {
            double amplitude = SwimKinematics.Envelope(style, along[p]);
            PortableMath.SinCos(2 * PortableMath.Pi * ((along[p] / wavelength) + lag), out double sine, out double cosine);
            cosines[p] = amplitude * sine;
            sines[p] = -amplitude * cosine;
        }
    }

    private double Slope(double[] values, int bone) => (values[bone] - values[bone + 1]) / lengths[bone];

    private double Reach(int point) => Math.Sqrt((cosines[point] * cosines[point]) + (sines[point] * sines[point]));

    /// <summary>Tail fins bend; the tapering tails of eels carry none to speak of.</summary>
    private void LagTail(SwimStyle style, double wavelength, double[] along)
    {
        int tip = along.Length - 1;
        if (tip < 3 || style == SwimStyle.Anguilliform)
        {
            return;
        }

        double[] c = new double[tip + 1];
        double[] s = new double[tip + 1];
        Fill(style, wavelength, along, FinLag, c, s);
        double fraction = (along[tip] - along[tip - 1]) / (along[tip] - along[tip - 2]);
        cosines[tip] = cosines[tip - 1] + ((1 - FinFraction) * (cosines[tip] - cosines[tip - 1])) + (FinFraction * fraction * (c[tip] - c[tip - 2]));
        sines[tip] = sines[tip - 1] + ((1 - FinFraction) * (sines[tip] - sines[tip - 1])) + (FinFraction * fraction * (s[tip] - s[tip - 2]));
    }
}
