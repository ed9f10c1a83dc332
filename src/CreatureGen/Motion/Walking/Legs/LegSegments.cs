using System.Numerics;
using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>The two parts of a leg that are solved for, at rest, with all that follows from their lengths and from how they stand to the hinge between them.</summary>
internal readonly struct LegSegments
{
    private static readonly double maxBendCosine = PortableMath.Cos(BendRange.Max);

    /// <summary>Measures the parts.</summary>
    /// <param name="upper">From the hip to the hinge, or, with the metatarsus folded, their sum; metres.</param>
    /// <param name="lower">From the hinge to the end, metres.</param>
    /// <param name="hinge">Unit.</param>
    /// <param name="minBendCosine">Cosine of the bend at its straightest.</param>
    public LegSegments(Vector3 upper, Vector3 lower, Vector3 hinge, double minBendCosine)
    {
        Upper = upper;
        float alongUpper = Vec.Dot(upper, hinge);
        float alongLower = Vec.Dot(lower, hinge);
        Vector3 a = upper - (hinge * alongUpper);
        Vector3 b = lower - (hinge * alongLower);
        double aa = Vec.LengthSquared(a);
        double bb = Vec.LengthSquared(b);
        double product = Math.Sqrt(aa * bb);
        double offset = alongUpper + alongLower;
        OffsetSquared = offset * offset;
        Squares = aa + bb;
        Product = 2 * product;
        Max = Math.Sqrt(Squares + (Product * minBendCosine));
        Min = Math.Sqrt(Math.Max(Squares + (Product * maxBendCosine), 0));
        double inverse = 1 / product;
        Cosine = Vec.Dot(a, b) * inverse;
        Sine = Vec.Dot(Vec.Cross(a, b), hinge) * inverse;
    }

    /// <summary>The first part.</summary>
    public Vector3 Upper { get; }

    /// <summary>Square of what the parts go along the hinge.</summary>
    public double OffsetSquared { get; }

    /// <summary>Sum of the squares of their lengths across the hinge.</summary>
    public double Squares { get; }

    /// <summary>Twice the product of these lengths.</summary>
    public double Product { get; }

    /// <summary>Greatest distance that they span across the hinge.</summary>
    public double Max { get; }

    /// <summary>Least distance.</summary>
    public double Min { get; }

    /// <summary>Cosine of their bend at rest.</summary>
    public double Cosine { get; }

    /// <summary>Its sine.</summary>
    public double Sine { get; }
}
