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

        // Multiplication and addition by component are exact on every platform.
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
            Vector4 w = s.Weights;
            ref readonly Rows m = ref rows[s.Joint0];
            Vector4 r0 = m.R0;
            Vector4 r1 = m.R1;
            Vector4 r2 = m.R2;
            Vector4 r3 = m.R3;
            if (w.Y > 0f)
            {
                r0 *= w.X;
                r1 *= w.X;
                r2 *= w.X;
                r3 *= w.X;
                m = ref rows[s.Joint1];
                r0 += m.R0 * w.Y;
                r1 += m.R1 * w.Y;
                r2 += m.R2 * w.Y;
                r3 += m.R3 * w.Y;
                if (w.Z > 0f)
                {
                    m = ref rows[s.Joint2];
                    r0 += m.R0 * w.Z;
                    r1 += m.R1 * w.Z;
                    r2 += m.R2 * w.Z;
                    r3 += m.R3 * w.Z;
                    if (w.W > 0f)
                    {
                        m = ref rows[s.Joint3];
                        r0 += m.R0 * w.W;
                        r1 += m.R1 * w.W;
                        r2 += m.R2 * w.W;
                        r3 += m.R3 * w.W;
                    }
                }
            }

            ref readonly Vector3 p = ref positions[i];
            Vector4 q = (r0 * p.X) + (r1 * p.Y) + (r2 * p.Z) + r3;
            movedPositions[i] = new Vector3(q.X, q.Y, q.Z);
            ref readonly Vector3 n = ref normals[i];
            Vector4 d = (r0 * n.X) + (r1 * n.Y) + (r2 * n.Z);
            Vector4 squares = d * d;
            float squared = squares.X + squares.Y + squares.Z;
            if (squared > 0f)
            {
                d *= 1f / (float)Math.Sqrt(squared);
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
