using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Motion.Winged;

/// <summary>The rods of a trunk from rear to front, so that a point has to ask only those beside it how far it is from them.</summary>
internal sealed class RodRow
{
    private const int Columns = 32;

    private readonly Rod[] rods;
    private readonly RodBox[] boxes;
    private readonly float[] rears;
    private readonly float[] fronts;
    private readonly int[] nearest = new int[Columns];
    private readonly float rear;
    private readonly float length;

    /// <summary>Takes rods, and by how much boxes about them are wider than they have to be.</summary>
    public RodRow(IReadOnlyCollection<Rod> rods, float slack)
    {
        this.rods = new Rod[rods.Count];
        rears = new float[rods.Count];
        fronts = new float[rods.Count];
        int next = 0;
        foreach (Rod rod in rods)
        {
            this.rods[next] = rod;
            rears[next++] = rod.Box(slack).Min.Z;
        }

        Array.Sort(rears, this.rods);
        boxes = Array.ConvertAll(this.rods, rod => rod.Box(slack));

        // The foremost end of all up to each: behind a point by more than the nearest rod is far, none of them counts.
        float front = float.MinValue;
        for (int i = 0; i < fronts.Length; i++)
        {
            fronts[i] = front = Math.Max(front, boxes[i].Max.Z);
        }

        rear = rears.Length > 0 ? rears[0] : 0f;
        length = Math.Max((front - rear) / Columns, float.Epsilon);
        for (int column = 0; column < Columns; column++)
        {
            nearest[column] = Math.Max(Array.FindLastIndex(rears, z => z <= rear + ((column + 0.5f) * length)), 0);
        }
    }

    /// <summary>From the surface of the nearest rod to a point; 0 or below within one, and the greatest number where there are none.</summary>
    public double Distance(Vector3 point)
    {
        double off = double.MaxValue;
        int start = nearest[Math.Min(Math.Max((int)((point.Z - rear) / length), 0), Columns - 1)];
        for (int i = start; i >= 0 && i < rods.Length && off > 0 && point.Z - fronts[i] < off; i--)
        {
            off = Nearer(i, point, off);
        }

        for (int i = start + 1; i < rods.Length && off > 0 && rears[i] - point.Z < off; i++)
        {
            off = Nearer(i, point, off);
        }

        return off;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private double Nearer(int rod, Vector3 point, double off) => boxes[rod].AwaySquared(point) < off * off ? Math.Min(off, rods[rod].Distance(point)) : off;
}
