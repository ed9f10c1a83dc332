using System.Collections.Generic;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Skinning;

/// <summary>How many edges the body's vertices lie away from the limbs: what a limb pulls along when it moves.</summary>
internal sealed class SocketSpread
{
    /// <summary>Number of rings of the body's vertices that follow a limb, the socket's border included.</summary>
    public const int Rings = 3;

    private readonly int[] first;
    private readonly List<Entry> entries;

    private SocketSpread(int[] first, List<Entry> entries)
    {
        this.first = first;
        this.entries = entries;
    }

    /// <summary>Walks out from the borders of the left sockets of all paired appendages.</summary>
    public static SocketSpread Measure(Surface surface, SurfaceAdjacency adjacency, IReadOnlyList<Appendage> appendages)
    {
        int[] first = new int[surface.Positions.Length];
        System.Array.Fill(first, -1);
        var spread = new SocketSpread(first, new List<Entry>(1024));
        var borders = new List<int>[appendages.Count];
        for (int v = 0; v < surface.Positions.Length; v++)
        {
            VertexAddress address = surface.Addresses[v];
            if (address.Appendage < 0 || address.Sign < 0 || !appendages[address.Appendage].Paired)
            {
                continue;
            }

            foreach (int n in adjacency.Of(v))
            {
                if (surface.Addresses[n].Appendage < 0 && !spread.Has(n, address.Appendage))
                {
                    spread.Put(n, address.Appendage, 0);
                    (borders[address.Appendage] ??= new List<int>(32)).Add(n);
                }
            }
        }

        for (int a = 0; a < borders.Length; a++)
        {
            List<int>? front = borders[a];
            for (int ring = 1; ring < Rings && front != null; ring++)
            {
                front = spread.Grow(surface, adjacency, front, (short)a, ring);
            }
        }

        return spread;
    }

    /// <summary>The first entry of a vertex, to be followed by <see cref="Next"/>; −1 for none.</summary>
    public int First(int vertex) => first[vertex];

    /// <summary>The entry after another.</summary>
    public int Next(int entry) => entries[entry].Next;

    /// <summary>The appendage of an entry, on the left side.</summary>
    public int Appendage(int entry) => entries[entry].Appendage;

    /// <summary>Edges from the socket's border, 0 on it.</summary>
    public int Distance(int entry) => entries[entry].Distance;

    private List<int> Grow(Surface surface, SurfaceAdjacency adjacency, List<int> front, short appendage, int ring)
    {
        var next = new List<int>(front.Count * 2);
        foreach (int v in front)
        {
            foreach (int n in adjacency.Of(v))
            {
                if (surface.Addresses[n].Appendage < 0 && !Has(n, appendage))
                {
                    Put(n, appendage, ring);
                    next.Add(n);
                }
            }
        }

        return next;
    }

    private bool Has(int vertex, short appendage)
    {
        for (int e = first[vertex]; e >= 0; e = entries[e].Next)
        {
            if (entries[e].Appendage == appendage)
            {
                return true;
            }
        }

        return false;
    }

    private void Put(int vertex, short appendage, int distance)
    {
        entries.Add(new Entry(first[vertex], appendage, (byte)distance));
        first[vertex] = entries.Count - 1;
    }

    private readonly struct Entry
    {
        public Entry(int next, short appendage, byte distance)
        {
            Next = next;
            Appendage = appendage;
            Distance = distance;
        }

        public int Next { get; }

        public short Appendage { get; }

        public byte Distance { get; }
    }
}
