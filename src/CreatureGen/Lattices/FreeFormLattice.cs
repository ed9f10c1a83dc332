using System;
using System.Globalization;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Lattices;

/// <summary>
/// A grid of control points in a parallelepiped that carries along any points inside: a trivariate Bézier volume. Immutable.
/// </summary>
/// <remarks>
/// <para>Based on: T. W. Sederberg and S. R. Parry, "Free-form deformation of solid geometric models" (1986). A point P has the local coordinates
/// s = (T×U)·(P−P0) / ((T×U)·S), t = (U×S)·(P−P0) / ((U×S)·T), u = (S×T)·(P−P0) / ((S×T)·U) (their equation 1), and goes to
/// Σ B(l, i)(s) · B(m, j)(t) · B(n, k)(u) · P(i, j, k) (their equation 2).</para>
/// <para>At rest the control points are evenly spaced and the sum is P itself, so it is computed as P plus the weighted sum of the control points' offsets
/// from rest: where nothing is displaced, nothing moves by a single bit.</para>
/// <para>A point outside the parallelepiped moves by as much as the point inside whose local coordinates are nearest; the polynomials would fling it far away.</para>
/// </remarks>
internal sealed class FreeFormLattice
{
    /// <summary>The largest degree along an axis; beyond it a Bézier volume hardly follows its points.</summary>
    public const int MaxDegree = 31;

    // Share of the volume of a box of the same edges below which the axes lie in a plane or on a line.
    private const double FlatFraction = 1e-6;

    private readonly Vector3[] offsets;
    private readonly Axis s;
    private readonly Axis t;
    private readonly Axis u;

    /// <summary>A lattice at rest with the given degrees; without them, the 3 × 3 × 11 control points of a creature's body.</summary>
    /// <param name="origin">The corner P0 of the parallelepiped, metres.</param>
    /// <param name="axisS">The edge S from the corner, of any length and direction, metres.</param>
    /// <param name="axisT">The edge T.</param>
    /// <param name="axisU">The edge U; the three must not lie in a plane. Right- or left-handed.</param>
    /// <param name="degreeS">Degree l along S, 1..<see cref="MaxDegree"/>; there are l + 1 control points.</param>
    /// <param name="degreeT">Degree m along T.</param>
    /// <param name="degreeU">Degree n along U.</param>
    /// <exception cref="ArgumentOutOfRangeException">A degree is out of its range.</exception>
    /// <exception cref="ArgumentException">A coordinate is not finite, or the axes span no volume.</exception>
    public FreeFormLattice(Vector3 origin, Vector3 axisS, Vector3 axisT, Vector3 axisU, int degreeS = 2, int degreeT = 2, int degreeU = 10)
    {
        CheckDegree(degreeS, nameof(degreeS));
        CheckDegree(degreeT, nameof(degreeT));
        CheckDegree(degreeU, nameof(degreeU));
        if (!IsFinite(origin))
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "the origin is {0}; expected finite coordinates", origin), nameof(origin));
        }

        if (!(Math.Abs(Axis.Volume(axisS, axisT, axisU)) > FlatFraction * Axis.Length(axisS) * Axis.Length(axisT) * Axis.Length(axisU)))
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "the axes {0}, {1} and {2} span no volume; expected three finite axes that do not lie in a plane", axisS, axisT, axisU), nameof(axisS));
        }

        Origin = origin;
        s = new Axis(axisS, axisT, axisU, degreeS);
        t = new Axis(axisT, axisU, axisS, degreeT);
        u = new Axis(axisU, axisS, axisT, degreeU);
        offsets = new Vector3[(degreeS + 1) * (degreeT + 1) * (degreeU + 1)];
    }

    private FreeFormLattice(FreeFormLattice rest, Vector3[] offsets)
    {
        Origin = rest.Origin;
        s = rest.s;
        t = rest.t;
        u = rest.u;
        this.offsets = offsets;
    }

    /// <summary>The corner P0 of the parallelepiped at rest, metres.</summary>
    public Vector3 Origin { get; }

    /// <summary>The edge S, metres.</summary>
    public Vector3 AxisS => s.Edge;

    /// <summary>The edge T, metres.</summary>
    public Vector3 AxisT => t.Edge;

    /// <summary>The edge U, metres.</summary>
    public Vector3 AxisU => u.Edge;

    /// <summary>Degree l along S; l + 1 control points.</summary>
    public int DegreeS => s.Degree;

    /// <summary>Degree m along T; m + 1 control points.</summary>
    public int DegreeT => t.Degree;

    /// <summary>Degree n along U; n + 1 control points.</summary>
    public int DegreeU => u.Degree;

    /// <summary>How far each control point is from its place at rest, metres; index (k · (m + 1) + j) · (l + 1) + i, so that a slice k is in one piece.</summary>
    public ReadOnlySpan<Vector3> Offsets => offsets;

    /// <summary>The index of control point (i, j, k) in <see cref="Offsets"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such control point.</exception>
    public int IndexOf(int i, int j, int k)
    {
        if ((uint)i > (uint)DegreeS || (uint)j > (uint)DegreeT || (uint)k > (uint)DegreeU)
        {
            throw new ArgumentOutOfRangeException(nameof(i), string.Format(CultureInfo.InvariantCulture, "control point ({0}, {1}, {2}); expected 0..{3}, 0..{4}, 0..{5}", i, j, k, DegreeS, DegreeT, DegreeU));
        }

        return (((k * (DegreeT + 1)) + j) * (DegreeS + 1)) + i;
    }

    /// <summary>The place of control point (i, j, k) at rest: P0 + i/l · S + j/m · T + k/n · U.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such control point.</exception>
    public Vector3 RestPoint(int i, int j, int k)
    {
        IndexOf(i, j, k);
        return Origin + (AxisS * ((float)i / DegreeS)) + (AxisT * ((float)j / DegreeT)) + (AxisU * ((float)k / DegreeU));
    }

    /// <summary>The place of control point (i, j, k).</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such control point.</exception>
    public Vector3 ControlPoint(int i, int j, int k) => RestPoint(i, j, k) + offsets[IndexOf(i, j, k)];

    /// <summary>The same lattice with its control points displaced from rest by the given offsets.</summary>
    /// <param name="displacements">One for each control point in the order of <see cref="Offsets"/>, metres; copied.</param>
    /// <exception cref="ArgumentException">Their number is not that of the control points, or one is not finite.</exception>
    public FreeFormLattice WithOffsets(ReadOnlySpan<Vector3> displacements)
    {
        if (displacements.Length != offsets.Length)
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "{0} offsets; expected one for each of the {1} control points", displacements.Length, offsets.Length), nameof(displacements));
        }

        for (int i = 0; i < displacements.Length; i++)
        {
            if (!IsFinite(displacements[i]))
            {
                throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "offset {0} is {1}; expected finite coordinates", i, displacements[i]), nameof(displacements));
            }
        }

        return new FreeFormLattice(this, displacements.ToArray());
    }

    /// <summary>The coordinates (s, t, u) of a point at rest: 0..1 each inside the parallelepiped.</summary>
    public Vector3 Local(Vector3 point) => new((float)s.At(point, Origin), (float)t.At(point, Origin), (float)u.At(point, Origin));

    /// <summary>Where the lattice carries a point.</summary>
    /// <param name="point">A finite point, same space and unit as the lattice.</param>
    /// <exception cref="ArgumentException">The point is not finite or goes beyond the largest float.</exception>
    public Vector3 Deform(Vector3 point)
    {
        Span<double> weights = stackalloc double[3 * (MaxDegree + 1)];
        return Deform(point, weights);
    }

    /// <summary>Where the lattice carries each of the points. Allocates nothing.</summary>
    /// <param name="points">Finite points, same space and unit as the lattice.</param>
    /// <param name="deformed">Filled; as long as <paramref name="points"/>, and may be the same memory.</param>
    /// <exception cref="ArgumentException">The lengths differ, or a point is not finite or goes beyond the largest float.</exception>
    public void Deform(ReadOnlySpan<Vector3> points, Span<Vector3> deformed)
    {
        if (deformed.Length != points.Length)
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "room for {0} points; expected {1}", deformed.Length, points.Length), nameof(deformed));
        }

        Span<double> weights = stackalloc double[3 * (MaxDegree + 1)];
        for (int i = 0; i < points.Length; i++)
        {
            deformed[i] = Deform(points[i], weights);
        }
    }

    private Vector3 Deform(Vector3 point, Span<double> weights)
    {
        Span<double> ws = weights.Slice(0, DegreeS + 1);
        Span<double> wt = weights.Slice(MaxDegree + 1, DegreeT + 1);
        Span<double> wu = weights.Slice(2 * (MaxDegree + 1), DegreeU + 1);
        Bernstein.Evaluate(Scalar.Clamp(s.At(point, Origin), 0, 1), ws);
        Bernstein.Evaluate(Scalar.Clamp(t.At(point, Origin), 0, 1), wt);
        Bernstein.Evaluate(Scalar.Clamp(u.At(point, Origin), 0, 1), wu);

        double x = 0, y = 0, z = 0;
        int index = 0;
        for (int k = 0; k < wu.Length; k++)
        {
            for (int j = 0; j < wt.Length; j++)
            {
                double row = wu[k] * wt[j];
                for (int i = 0; i < ws.Length; i++)
                {
                    double weight = row * ws[i];
                    Vector3 offset = offsets[index++];
                    x += weight * offset.X;
                    y += weight * offset.Y;
                    z += weight * offset.Z;
                }
            }
        }

        var deformed = new Vector3((float)(point.X + x), (float)(point.Y + y), (float)(point.Z + z));
        return IsFinite(deformed)
            ? deformed
            : throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "the point {0} goes to {1}; expected finite coordinates", point, deformed), nameof(point));
    }

    private static void CheckDegree(int degree, string name)
    {
        if (degree < 1 || degree > MaxDegree)
        {
            throw new ArgumentOutOfRangeException(name, degree, string.Format(CultureInfo.InvariantCulture, "expected a degree of 1..{0}", MaxDegree));
        }
    }

    private static bool IsFinite(Vector3 v) => Math.Abs(v.X) <= float.MaxValue && Math.Abs(v.Y) <= float.MaxValue && Math.Abs(v.Z) <= float.MaxValue;

    /// <summary>An edge, and the vector whose product with a point's distance from the corner is its coordinate along the edge.</summary>
    private readonly struct Axis
    {
        private readonly double x;
        private readonly double y;
        private readonly double z;

        public Axis(Vector3 edge, Vector3 next, Vector3 last, int degree)
        {
            Edge = edge;
            Degree = degree;
            double volume = Volume(edge, next, last);
            x = (((double)next.Y * last.Z) - ((double)next.Z * last.Y)) / volume;
            y = (((double)next.Z * last.X) - ((double)next.X * last.Z)) / volume;
            z = (((double)next.X * last.Y) - ((double)next.Y * last.X)) / volume;
        }

        public Vector3 Edge { get; }

        public int Degree { get; }

        public double At(Vector3 point, Vector3 origin) => (x * ((double)point.X - origin.X)) + (y * ((double)point.Y - origin.Y)) + (z * ((double)point.Z - origin.Z));

        /// <summary>(b × c) · a, the same for b, c, a.</summary>
        public static double Volume(Vector3 a, Vector3 b, Vector3 c) =>
            ((((double)b.Y * c.Z) - ((double)b.Z * c.Y)) * a.X)
            + ((((double)b.Z * c.X) - ((double)b.X * c.Z)) * a.Y)
            + ((((double)b.X * c.Y) - ((double)b.Y * c.X)) * a.Z);

        public static double Length(Vector3 v) => Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y) + ((double)v.Z * v.Z));
    }
}
