using System;
using System.Numerics;
using System.Runtime.InteropServices;
#if NET
using CreatureGen.Maths;
#endif

namespace CreatureGen.Skinning;

/// <summary>Linear blend skinning on the processor, over spans that the caller owns. Nothing is allocated.</summary>
/// <remarks>
/// Every vertex is moved by the weighted mean of the matrices of its joints. Normals are moved by the same mean and brought back to unit length.
/// Influences of weight 0 cost nothing, since weights are in descending order.
/// </remarks>
public static class CpuSkinning
{
    /// <summary>Moves positions and normals.</summary>
    /// <param name="matrices">One per joint, from <see cref="SkinMatrices"/>.</param>
    /// <param name="weights">One per vertex.</param>
    /// <param name="positions">Rest positions, one per vertex.</param>
    /// <param name="normals">Unit rest normals, one per vertex.</param>
    /// <param name="movedPositions">Receives the positions, one per vertex.</param>
    /// <param name="movedNormals">Receives the unit normals, one per vertex.</param>
    /// <exception cref="ArgumentException">The spans of vertices differ in length.</exception>
    /// <exception cref="IndexOutOfRangeException">A weight names a joint without a matrix.</exception>
    public static void Skin(
        ReadOnlySpan<Matrix4x4> matrices,
        ReadOnlySpan<SkinWeights> weights,
        ReadOnlySpan<Vector3> positions,
        ReadOnlySpan<Vector3> normals,
        Span<Vector3> movedPositions,
        Span<Vector3> movedNormals)
    {
        int count = weights.Length;
        if (positions.Length != count || normals.Length != count || movedPositions.Length != count || movedNormals.Length != count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{count} weights, {positions.Length} and {movedPositions.Length} positions, {normals.Length} and {movedNormals.Length} normals; expected one of each per vertex"));
        }

        // Multiplication and addition by component are exact on every platform. Numbers are put into all four places beforehand: an operator that takes one is a call in browsers.
        ReadOnlySpan<Rows> rows = MemoryMarshal.Cast<Matrix4x4, Rows>(matrices);
        int first = 0;
#if NET
        if (FourVectors.Pay)
        {
            first = FourVertices.Skin(matrices, weights, positions, normals, movedPositions, movedNormals);
        }
#endif
        for (int i = first; i < count; i++)
        {
            ref readonly SkinWeights s = ref weights[i];
            Vector4 weight = s.Weights;
            ref readonly Rows m = ref rows[s.Joint0];
            Vector4 r0 = m.R0;
            Vector4 r1 = m.R1;
            Vector4 r2 = m.R2;
            Vector4 r3 = m.R3;
            if (weight.Y > 0f)
            {
                var x = new Vector4(weight.X);
                r0 *= x;
                r1 *= x;
                r2 *= x;
                r3 *= x;
                m = ref rows[s.Joint1];
                var y = new Vector4(weight.Y);
                r0 += m.R0 * y;
                r1 += m.R1 * y;
                r2 += m.R2 * y;
                r3 += m.R3 * y;
                if (weight.Z > 0f)
                {
                    m = ref rows[s.Joint2];
                    var z = new Vector4(weight.Z);
                    r0 += m.R0 * z;
                    r1 += m.R1 * z;
                    r2 += m.R2 * z;
                    r3 += m.R3 * z;
                    if (weight.W > 0f)
                    {
                        m = ref rows[s.Joint3];
                        var w = new Vector4(weight.W);
                        r0 += m.R0 * w;
                        r1 += m.R1 * w;
                        r2 += m.R2 * w;
                        r3 += m.R3 * w;
                    }
                }
            }

            ref readonly Vector3 p = ref positions[i];
            Vector4 q = (r0 * new Vector4(p.X)) + (r1 * new Vector4(p.Y)) + (r2 * new Vector4(p.Z)) + r3;
            movedPositions[i] = new Vector3(q.X, q.Y, q.Z);
            ref readonly Vector3 n = ref normals[i];
            Vector4 d = (r0 * new Vector4(n.X)) + (r1 * new Vector4(n.Y)) + (r2 * new Vector4(n.Z));
            Vector4 squares = d * d;
            float squared = squares.X + squares.Y + squares.Z;
            if (squared > 0f)
            {
                d *= new Vector4(1f / (float)Math.Sqrt(squared));
                movedNormals[i] = new Vector3(d.X, d.Y, d.Z);
            }
            else
            {
                movedNormals[i] = n;
            }
        }
    }

    /// <summary>A matrix by its rows.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private readonly struct Rows
    {
        public readonly Vector4 R0;
        public readonly Vector4 R1;
        public readonly Vector4 R2;
        public readonly Vector4 R3;
    }
}
