using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>
/// Vertices joined by exactly equal position, as needed before a drawn mesh is measured: its vertices are split where texture coordinates or normals part.
/// </summary>
/// <remarks>Zero and minus zero are the same place. A position that is not finite is joined to none.</remarks>
internal sealed class VertexWelding
{
    private readonly Vector3[] positions;
    private readonly int[] newIndex;

    // Slots hold an index of a distinct position plus one; the order of the slots never shows.
    private readonly int[] slots;

    private VertexWelding(Vector3[] positions, int[] newIndex, int[] slots)
    {
        this.positions = positions;
        this.newIndex = newIndex;
        this.slots = slots;
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

        int[] slots = new int[capacity];
        int[] newIndex = new int[positions.Length];
        var distinct = new Vector3[positions.Length];
        int count = 0;
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3 p = positions[v];
            if (!TriangleList.IsFinite(p))
            {
                distinct[count] = p;
                newIndex[v] = count++;
                continue;
            }

            int slot = SlotOf(p, slots, distinct);
            if (slots[slot] == 0)
            {
                distinct[count] = p;
                slots[slot] = ++count;
            }

            newIndex[v] = slots[slot] - 1;
        }

        Array.Resize(ref distinct, count);
        return new VertexWelding(distinct, newIndex, slots);
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

    /// <summary>The index in <see cref="Positions"/> of a place; −1 where no vertex is, and for a place that is not finite.</summary>
    public int IndexAt(Vector3 place) => TriangleList.IsFinite(place) ? slots[SlotOf(place, slots, positions)] - 1 : -1;

    /// <summary>The slot that holds a position, or the empty one in which it belongs.</summary>
    private static int SlotOf(Vector3 p, int[] slots, Vector3[] distinct)
    {
        int slot = Hash(p) & (slots.Length - 1);
        while (slots[slot] != 0 && distinct[slots[slot] - 1] != p)
        {
            slot = (slot + 1) & (slots.Length - 1);
        }

        return slot;
    }

    private static int Hash(Vector3 p)
    {
        unchecked
        {
            ulong hash = Mix(Mix(Mix(0, p.X), p.Y), p.Z);
            return (int)(hash >> 33);
        }
    }

    private static ulong Mix(ulong hash, float coordinate)
    {
        // Minus zero and zero are the same place.
        uint word = (uint)BitConverter.SingleToInt32Bits(coordinate + 0f);
        unchecked
        {
            hash = (hash ^ word) * 0x9E3779B97F4A7C15UL;
            return hash ^ (hash >> 29);
        }
    }
}
