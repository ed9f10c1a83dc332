using System;
using System.Numerics;
using CreatureGen.Maths;
#if NET
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
#endif

namespace CreatureGen.Rigging;

/// <summary>A capsule in model space around points of the skin.</summary>
/// <remarks>
/// The axis has a given direction and runs through the middle of the points; the radius is a percentile of their distances from it, so that a few far points (ears of a head,
/// fingers of a hand) do not blow it up; the length covers all but the outermost points.
/// </remarks>
internal readonly struct CapsuleFit
{
    /// <summary>Share of the points that lie within the radius: as much of the skin stands out of the capsule as lies in it where a section is not round.</summary>
    private const double RadiusFraction = 0.7;

    /// <summary>Share of the points at each end that the capsule may leave out.</summary>
    private const double EndFraction = 0.03;

    private CapsuleFit(Vector3 start, Vector3 end, float radius)
    {
        Start = start;
        End = end;
        Radius = radius;
    }

    /// <summary>Centre of the first half sphere.</summary>
    public Vector3 Start { get; }

    /// <summary>Centre of the second half sphere, further along the direction.</summary>
    public Vector3 End { get; }

    public float Radius { get; }

    /// <summary>Fits a capsule.</summary>
    /// <param name="points">At least one.</param>
    /// <param name="origin">A point that distances along the axis are counted from.</param>
    /// <param name="direction">Unit direction of the axis.</param>
    /// <param name="median">Whether the axis has to stay in the sagittal plane.</param>
    /// <param name="scratch">At least twice as long as the points.</param>
    public static CapsuleFit Around(ReadOnlySpan<Vector3> points, Vector3 origin, Vector3 direction, bool median, Span<float> scratch)
    {
        Vector3 mean = Vector3.Zero;
        foreach (Vector3 p in points)
        {
            mean += p - origin;
        }

        Vector3 axis = origin + Vec.Reject(mean / points.Length, direction);
        axis.X = median ? 0f : axis.X;
        Span<float> along = scratch.Slice(0, points.Length);
        Span<float> away = scratch.Slice(points.Length, points.Length);
        int measured = 0;
#if NET
        measured = FourVectors.Pay ? Measure(points, axis, direction, along, away) : 0;
#endif
        for (int i = measured; i < points.Length; i++)
        {
            Vector3 d = points[i] - axis;
            along[i] = Vec.Dot(d, direction);
            away[i] = Vec.Length(d - Vec.Scale(direction, along[i]));
        }

        float radius = Selection.Percentile(away, RadiusFraction);
        float first = Selection.Percentile(along, EndFraction);
        float last = Selection.Percentile(along, 1 - EndFraction);
        float middle = (first + last) / 2f;
        float half = Math.Max(((last - first) / 2f) - radius, 0f);
        return new CapsuleFit(axis + (direction * (middle - half)), axis + (direction * (middle + half)), radius);
    }

#if NET
    /// <summary>Measures points along an axis and away from it, four at a time, and gives how many: the same bits as one by one, in a third of the time, which is a twenty-fifth of a creature's.</summary>
    private static int Measure(ReadOnlySpan<Vector3> points, Vector3 axis, Vector3 direction, Span<float> along, Span<float> away)
    {
        Vector128<float> origin = axis.AsVector128();
        Vector128<float> forward = direction.AsVector128();
        ref float numbers = ref Unsafe.As<Vector3, float>(ref MemoryMarshal.GetReference(points));
        int i = 0;

        // A load takes a number of the next point along: the last is left.
        for (; i < points.Length - FourVectors.Count; i += FourVectors.Count)
        {
            nuint place = (nuint)i * 3;
            Vector128<float> a = Vector128.LoadUnsafe(ref numbers, place) - origin;
            Vector128<float> b = Vector128.LoadUnsafe(ref numbers, place + 3) - origin;
            Vector128<float> c = Vector128.LoadUnsafe(ref numbers, place + 6) - origin;
            Vector128<float> d = Vector128.LoadUnsafe(ref numbers, place + 9) - origin;
            Vector128<float> dots = FourVectors.SumsOfThree(a * forward, b * forward, c * forward, d * forward);
            a -= forward * FourVectors.First(dots);
            b -= forward * FourVectors.Second(dots);
            c -= forward * FourVectors.Third(dots);
            d -= forward * FourVectors.Fourth(dots);
            dots.StoreUnsafe(ref along[i]);
            Vector128.Sqrt(FourVectors.SumsOfThree(a * a, b * b, c * c, d * d)).StoreUnsafe(ref away[i]);
        }

        return i;
    }
#endif
}
