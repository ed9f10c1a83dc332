using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Gltf;

/// <summary>The buffers of a mesh as bytes, each checked while it is written.</summary>
internal static class VertexWriter
{
    /// <summary>Writes positions, three floats each, and returns the corners of their bounding box as they were written.</summary>
    /// <exception cref="InvalidOperationException">A position is not finite.</exception>
    public static (Vector3 Min, Vector3 Max) Positions(ReadOnlySpan<Vector3> positions, Span<byte> destination)
    {
        float minX = float.PositiveInfinity, minY = float.PositiveInfinity, minZ = float.PositiveInfinity;
        float maxX = float.NegativeInfinity, maxY = float.NegativeInfinity, maxZ = float.NegativeInfinity;
        for (int i = 0; i < positions.Length; i++)
        {
            Vector3 p = positions[i];
            if (!(float.IsFinite(p.X) && float.IsFinite(p.Y) && float.IsFinite(p.Z)))
            {
                throw ExportError.At(Vertex(i), "its position is " + ExportError.Text(p), "finite numbers");
            }

            minX = p.X < minX ? p.X : minX;
            minY = p.Y < minY ? p.Y : minY;
            minZ = p.Z < minZ ? p.Z : minZ;
            maxX = p.X > maxX ? p.X : maxX;
            maxY = p.Y > maxY ? p.Y : maxY;
            maxZ = p.Z > maxZ ? p.Z : maxZ;
            Write(destination.Slice(12 * i, 12), p);
        }

        return (new Vector3(minX + 0f, minY + 0f, minZ + 0f), new Vector3(maxX + 0f, maxY + 0f, maxZ + 0f));
    }

    /// <summary>Writes normals, three floats each.</summary>
    /// <exception cref="InvalidOperationException">A normal is not of unit length.</exception>
    public static void Normals(ReadOnlySpan<Vector3> normals, Span<byte> destination)
    {
        for (int i = 0; i < normals.Length; i++)
        {
            Vector3 n = normals[i];
            if (!(Math.Abs(Vec.LengthSquared(n) - 1f) <= 2f * Tolerance.UnitLength))
            {
                throw ExportError.At(Vertex(i), "its normal is " + ExportError.Text(n), "a unit vector");
            }

            Write(destination.Slice(12 * i, 12), n);
        }
    }

    /// <summary>Writes tangents, four floats each.</summary>
    /// <exception cref="InvalidOperationException">A tangent is not of unit length, or its side is not ±1.</exception>
    public static void Tangents(ReadOnlySpan<Vector4> tangents, Span<byte> destination)
    {
        for (int i = 0; i < tangents.Length; i++)
        {
            Vector4 t = tangents[i];
            var direction = new Vector3(t.X, t.Y, t.Z);
            if (!(Math.Abs(Vec.LengthSquared(direction) - 1f) <= 2f * Tolerance.UnitLength) || Math.Abs(t.W) != 1f)
            {
                throw ExportError.At(Vertex(i), "its tangent is " + ExportError.Text(direction) + FormattableString.Invariant($" with side {t.W}"), "a unit vector and a side of 1 or −1");
            }

            Write(destination.Slice(16 * i, 12), direction);
            LittleEndian.Write(destination, (16 * i) + 12, t.W);
        }
    }

    /// <summary>Writes texture coordinates, two floats each.</summary>
    /// <exception cref="InvalidOperationException">A coordinate is not finite.</exception>
    public static void Texcoords(ReadOnlySpan<Vector2> texcoords, Span<byte> destination)
    {
        for (int i = 0; i < texcoords.Length; i++)
        {
            Vector2 t = texcoords[i];
            if (!(float.IsFinite(t.X) && float.IsFinite(t.Y)))
            {
                throw ExportError.At(Vertex(i), FormattableString.Invariant($"its texture coordinates are ({t.X}, {t.Y})"), "finite numbers");
            }

            Span<byte> at = destination.Slice(8 * i, 8);
            LittleEndian.Write(at, 0, t.X);
            LittleEndian.Write(at, 4, t.Y);
        }
    }

    /// <summary>Writes linear colours as red, green, blue and full opacity, each a 16-bit fraction.</summary>
    /// <exception cref="InvalidOperationException">A component is outside 0..1.</exception>
    public static void Colours(ReadOnlySpan<Vector3> colours, Span<byte> destination)
    {
        for (int i = 0; i < colours.Length; i++)
        {
            Vector3 c = colours[i];
            if (!(c.X >= 0f && c.X <= 1f && c.Y >= 0f && c.Y <= 1f && c.Z >= 0f && c.Z <= 1f))
            {
                throw ExportError.At(Vertex(i), "its colour is " + ExportError.Text(c), "components of 0..1");
            }

            Span<byte> at = destination.Slice(8 * i, 8);
            LittleEndian.Write(at, 0, Fraction(c.X));
            LittleEndian.Write(at, 2, Fraction(c.Y));
            LittleEndian.Write(at, 4, Fraction(c.Z));
            LittleEndian.Write(at, 6, ushort.MaxValue);
        }
    }

    /// <summary>Writes triangle corners as 16-bit integers.</summary>
    /// <exception cref="InvalidOperationException">A triangle uses a vertex twice.</exception>
    public static void ShortIndices(ReadOnlySpan<int> corners, int firstTriangle, Span<byte> destination)
    {
        for (int i = 0; i < corners.Length; i += 3)
        {
            ReadOnlySpan<int> triangle = corners.Slice(i, 3);
            RequireThreeVertices(triangle, firstTriangle + (i / 3));
            Span<byte> at = destination.Slice(2 * i, 6);
            LittleEndian.Write(at, 0, (ushort)triangle[0]);
            LittleEndian.Write(at, 2, (ushort)triangle[1]);
            LittleEndian.Write(at, 4, (ushort)triangle[2]);
        }
    }

    /// <summary>Writes triangle corners as 32-bit integers.</summary>
    /// <exception cref="InvalidOperationException">A triangle uses a vertex twice.</exception>
    public static void Indices(ReadOnlySpan<int> corners, int firstTriangle, Span<byte> destination)
    {
        for (int i = 0; i < corners.Length; i += 3)
        {
            ReadOnlySpan<int> triangle = corners.Slice(i, 3);
            RequireThreeVertices(triangle, firstTriangle + (i / 3));
            Span<byte> at = destination.Slice(4 * i, 12);
            LittleEndian.Write(at, 0, (uint)triangle[0]);
            LittleEndian.Write(at, 4, (uint)triangle[1]);
            LittleEndian.Write(at, 8, (uint)triangle[2]);
        }
    }

    /// <summary>A vertex in a message.</summary>
    public static string Vertex(int index) => FormattableString.Invariant($"vertex {index}");

    private static void Write(Span<byte> at, Vector3 v)
    {
        LittleEndian.Write(at, 0, v.X);
        LittleEndian.Write(at, 4, v.Y);
        LittleEndian.Write(at, 8, v.Z);
    }

    private static ushort Fraction(float x) => (ushort)(((double)x * ushort.MaxValue) + 0.5);

    private static void RequireThreeVertices(ReadOnlySpan<int> triangle, int index)
    {
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        {
            throw Broken(triangle, index);
        }
    }

    private static InvalidOperationException Broken(ReadOnlySpan<int> triangle, int index) =>
        ExportError.At(FormattableString.Invariant($"triangle {index}"), FormattableString.Invariant($"its corners are the vertices {triangle[0]}, {triangle[1]} and {triangle[2]}"), "three different vertices");
}
