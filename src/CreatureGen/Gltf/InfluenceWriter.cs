using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Skinning;

namespace CreatureGen.Gltf;

/// <summary>Joint influences as bytes, checked while they are written.</summary>
internal static class InfluenceWriter
{
    /// <summary>Writes four joint indices of one byte for each vertex, and checks its joints and weights.</summary>
    /// <exception cref="InvalidOperationException">The influences of a vertex are not as <see cref="SkinWeights"/> promises.</exception>
    public static void ByteJoints(ReadOnlySpan<SkinWeights> influences, int jointCount, Span<byte> destination)
    {
        for (int i = 0; i < influences.Length; i++)
        {
            SkinWeights s = influences[i];
            Require(s, jointCount, i);
            Span<byte> at = destination.Slice(4 * i, 4);
            at[0] = (byte)s.Joint0;
            at[1] = (byte)s.Joint1;
            at[2] = (byte)s.Joint2;
            at[3] = (byte)s.Joint3;
        }
    }

    /// <summary>Writes four joint indices of two bytes for each vertex, and checks its joints and weights.</summary>
    /// <exception cref="InvalidOperationException">The influences of a vertex are not as <see cref="SkinWeights"/> promises.</exception>
    public static void ShortJoints(ReadOnlySpan<SkinWeights> influences, int jointCount, Span<byte> destination)
    {
        for (int i = 0; i < influences.Length; i++)
        {
            SkinWeights s = influences[i];
            Require(s, jointCount, i);
            Span<byte> at = destination.Slice(8 * i, 8);
            LittleEndian.Write(at, 0, (ushort)s.Joint0);
            LittleEndian.Write(at, 2, (ushort)s.Joint1);
            LittleEndian.Write(at, 4, (ushort)s.Joint2);
            LittleEndian.Write(at, 6, (ushort)s.Joint3);
        }
    }

    /// <summary>Writes four weights as floats for each vertex.</summary>
    public static void Weights(ReadOnlySpan<SkinWeights> influences, Span<byte> destination)
    {
        for (int i = 0; i < influences.Length; i++)
        {
            Vector4 w = SumToOne(influences[i].Weights);
            Span<byte> at = destination.Slice(16 * i, 16);
            LittleEndian.Write(at, 0, w.X);
            LittleEndian.Write(at, 4, w.Y);
            LittleEndian.Write(at, 8, w.Z);
            LittleEndian.Write(at, 12, w.W);
        }
    }

    /// <summary>
    /// The same weights, rounded so that they sum to one as closely as floats can: divided by their sum in double precision,
    /// and what rounding leaves added to the first, which is the largest. Equal weights stay equal.
    /// </summary>
    public static Vector4 SumToOne(Vector4 weights)
    {
        // What follows one joint alone, as many vertices do, needs none of three divisions.
        if (weights == Vector4.UnitX)
        {
            return weights;
        }

        double sum = (double)weights.X + weights.Y + weights.Z + weights.W;
        float y = (float)(weights.Y / sum);
        float z = (float)(weights.Z / sum);
        float w = (float)(weights.W / sum);
        return new Vector4((float)(1.0 - ((double)y + z + w)), y, z, w);
    }

    private static void Require(in SkinWeights s, int jointCount, int vertex)
    {
        Vector4 w = s.Weights;
        float sum = w.X + w.Y + w.Z + w.W;
        bool descending = w.X >= w.Y && w.Y >= w.Z && w.Z >= w.W && w.W >= 0f;
        if (!(descending && Math.Abs(sum - 1f) <= Tolerance.WeightSum))
        {
            throw ExportError.At(VertexWriter.Vertex(vertex), "its weights are " + ExportError.Text(w), "none negative, in descending order, with a sum of one");
        }

        bool known = (uint)s.Joint0 < (uint)jointCount && (uint)s.Joint1 < (uint)jointCount && (uint)s.Joint2 < (uint)jointCount && (uint)s.Joint3 < (uint)jointCount;
        bool empty = (w.Y > 0f || s.Joint1 == 0) && (w.Z > 0f || s.Joint2 == 0) && (w.W > 0f || s.Joint3 == 0);
        bool distinct = (w.Y == 0f || s.Joint1 != s.Joint0)
            && (w.Z == 0f || (s.Joint2 != s.Joint0 && s.Joint2 != s.Joint1))
            && (w.W == 0f || (s.Joint3 != s.Joint0 && s.Joint3 != s.Joint1 && s.Joint3 != s.Joint2));
        if (!(known && empty && distinct))
        {
            throw ExportError.At(
                VertexWriter.Vertex(vertex),
                FormattableString.Invariant($"its joints are {s.Joint0}, {s.Joint1}, {s.Joint2} and {s.Joint3} with weights ") + ExportError.Text(w),
                FormattableString.Invariant($"different joints of 0..{jointCount - 1}, and joint 0 where the weight is zero"));
        }
    }
}
