using System;
using System.Numerics;
using System.Runtime.InteropServices;

namespace CreatureGen.Geometry;

/// <summary>
/// Vertices joined by exactly equal position, as needed before a drawn mesh is measured: its vertices are split where texture coordinates or normals part.
/// </summary>
/// <remarks>Zero and minus zero are the same place. A position that is not finite is joined to none.</remarks>
internal sealed class VertexWelding
{
    private readonly Vector3[] positions;
    private readonly int[] newIndex;

    private VertexWelding(Vector3[] positions, int[] newIndex)
    {
        this.positions = positions;
        this.newIndex = newIndex;
    }

    /// <summary>The distinct positions, in the order in which they first occurred.</summary>
    public ReadOnlySpan<Vector3> Positions => positions;

    /// <summary>For each vertex before welding, its index in <see cref="Positions"/>.</summary>
    public ReadOnlySpan<int> NewIndex => newIndex;

    /// <summary>Joins the vertices with equal positions.</summary>
    public static VertexWelding Weld(ReadOnlySpan<Vector3> positions)
    {
        int capacity = 16;
        while (capacity < 2 * positions.Length)
        {
            capacity *= 2;
        }

        // Slots hold an index of a distinct position plus one; the order of the slots never shows.
        int[] slots = new int[capacity];
        int[] newIndex = new int[positions.Length];
        var distinct = new Vector3[positions.Length];
        int count = 0;
        ReadOnlySpan<int> bits = MemoryMarshal.Cast<Vector3, int>(positions);
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3 p = positions[v];
            if (!TriangleList.IsFinite(p))
            {
                distinct[count] = p;
                newIndex[v] = count++;
                continue;
            }

            int slot = Hash(bits.Slice(3 * v, 3)) & (capacity - 1);
            while (slots[slot] != 0 && distinct[slots[slot] - 1] != p)
            {
                slot = (slot + 1) & (capacity - 1);
            }

            if (slots[slot] == 0)
            {
                distinct[count] = p;
                slots[slot] = ++count;
            }

            newIndex[v] = slots[slot] - 1;
        }

        Array.Resize(ref distinct, count);
        return new VertexWelding(distinct, newIndex);
    }

    /// <summary>The same triangles between the welded vertices.</summary>
    /// <param name="triangles">Indices of vertices before welding, three per triangle.</param>
    /// <exception cref="ArgumentException">The indices are not three per triangle, or one is out of range.</exception>
    public int[] Apply(ReadOnlySpan<int> triangles)
    {
        TriangleList.Count(newIndex.Length, triangles);
        int[] welded = new int[triangles.Length];
        for (int i = 0; i < welded.Length; i++)
        {
            welded[i] = newIndex[triangles[i]];
        }

        return welded;
    }

    private static int Hash(ReadOnlySpan<int> bits)
    {
        const uint MinusZero = 0x80000000u;
        unchecked
        {
            ulong hash = 0;
            foreach (int b in bits)
            {
                uint word = (uint)b == MinusZero ? 0u : (uint)b;
                hash = (hash ^ word) * 0x9E3779B97F4A7C15UL;
                hash ^= hash >> 29;
            }

            return (int)(hash >> 33);
        }
    }
}
