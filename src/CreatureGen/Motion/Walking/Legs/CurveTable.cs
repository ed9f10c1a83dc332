using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>A function of 0..1 as a table: read in a few operations.</summary>
internal sealed class CurveTable
{
    private const int Steps = 256;
    private readonly float[] values;

    private CurveTable(float[] values) => this.values = values;

    /// <summary>0 at both ends with slope 0, 1 at <paramref name="peak"/>: (u/m)^a ((1 − u)/(1 − m))^b with b = a(1 − m)/m.</summary>
    /// <param name="peak">m, 0..1.</param>
    /// <param name="rise">a; both exponents have to stay above 1, or the slope at the ends is infinite.</param>
    public static CurveTable Bell(double peak, double rise)
    {
        double fall = rise * (1 - peak) / peak;
        var values = new float[Steps + 1];
        for (int i = 0; i <= Steps; i++)
        {
            double u = i / (double)Steps;
            values[i] = (float)(PortableMath.Pow(u / peak, rise) * PortableMath.Pow((1 - u) / (1 - peak), fall));
        }

        return new CurveTable(values);
    }

    /// <summary>Its value; beyond 0..1 that of the nearer end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float At(float u)
    {
        float x = Math.Min(Math.Max(u, 0f), 1f) * Steps;
        int i = Math.Min((int)x, Steps - 1);
        float a = values[i];
        return a + ((values[i + 1] - a) * (x - i));
    }
}
