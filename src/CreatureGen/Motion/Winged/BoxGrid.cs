using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Motion.Winged;

/// <summary>Boxes by the cells of a grid seen from above, so that a point has to ask few of them whether it is within.</summary>
internal sealed class BoxGrid
{
    private const int Cells = 24;

    private readonly float left;
    private readonly float rear;
    private readonly float width;
    private readonly float length;
    private readonly int[] starts = new int[(Cells * Cells) + 1];
    private readonly int[] numbers;

    /// <summary>Takes boxes by their numbers.</summary>
    /// <param name="boxes">Least and greatest corner of each.</param>
    public BoxGrid(IReadOnlyList<(Vector3 Min, Vector3 Max)> boxes)
    {
        (left, rear) = (float.MaxValue, float.MaxValue);
        (float right, float front) = (float.MinValue, float.MinValue);
        foreach ((Vector3 min, Vector3 max) in boxes)
        {
            (left, right) = (Math.Min(left, min.X), Math.Max(right, max.X));
            (rear, front) = (Math.Min(rear, min.Z), Math.Max(front, max.Z));
        }

        width = Math.Max((right - left) / Cells, float.Epsilon);
        length = Math.Max((front - rear) / Cells, float.Epsilon);
        var found = new List<int>();
        for (int cell = 0; cell < Cells * Cells; cell++)
        {
            (int row, int column) = (cell / Cells, cell % Cells);
            for (int i = 0; i < boxes.Count; i++)
            {
                (Vector3 min, Vector3 max) = boxes[i];
                if (Column(min.X) <= column && column <= Column(max.X) && Row(min.Z) <= row && row <= Row(max.Z))
                {
                    found.Add(i);
                }
            }

            starts[cell + 1] = found.Count;
        }

        numbers = found.ToArray();
    }

    /// <summary>Numbers of the boxes that may hold a point, by rising numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public ReadOnlySpan<int> At(Vector3 point)
    {
        float across = (point.X - left) / width;
        float along = (point.Z - rear) / length;
        if (!(across >= 0f && across <= Cells && along >= 0f && along <= Cells))
        {
            return default;
        }

        int cell = (Row(point.Z) * Cells) + Column(point.X);
        return numbers.AsSpan(starts[cell], starts[cell + 1] - starts[cell]);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Column(float x) => Math.Min((int)((x - left) / width), Cells - 1);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Row(float z) => Math.Min((int)((z - rear) / length), Cells - 1);
}
