#if NET
using System;
using System.Numerics;
using System.Runtime.Intrinsics;

namespace CreatureGen.Geometry;

/// <summary>Which of four boxes meet another, all four at once: the walk down a <see cref="TriangleTree"/> takes less than half of the time of one by one. Whole numbers, so that the answers are the same.</summary>
internal static class FourBoxes
{
    /// <summary>For each set of four, as bits, where those in it come from when they are moved to the front; a number of 64 bits is two of 32.</summary>
    private static readonly Vector256<int>[] fronts = Fronts();

    /// <summary>Whether there are registers for four numbers.</summary>
    public static bool Pay => Vector256.IsHardwareAccelerated;

    /// <summary>Adds those of sixteen pairs of boxes that meet, those of one box of the second four after the other.</summary>
    /// <param name="lowA">Lower corners of the first four.</param>
    /// <param name="highA">Their upper corners, guarded.</param>
    /// <param name="lowB">Lower corners of the second four.</param>
    /// <param name="highB">Their upper corners, guarded.</param>
    /// <param name="pair">The pair of the first of both.</param>
    /// <param name="step">What a pair is more for the next of the first four; for the next of the second it is one more.</param>
    /// <param name="output">Receives the pairs; with room for all sixteen.</param>
    /// <param name="count">How many there are already.</param>
    /// <returns>How many there are now.</returns>
    public static int AddMeeting(ReadOnlySpan<ulong> lowA, ReadOnlySpan<ulong> highA, ReadOnlySpan<ulong> lowB, ReadOnlySpan<ulong> highB, ulong pair, ulong step, ulong[] output, int count)
    {
        Vector256<ulong> low = Vector256.Create(lowA);
        Vector256<ulong> high = Vector256.Create(highA);
        Vector256<ulong> guards = Vector256.Create(BoxCode.Guards);
        Vector256<ulong> pairs = Vector256.Create(pair, pair + step, pair + (2 * step), pair + (3 * step));
        for (int j = 0; j < TriangleTree.Branching; j++)
        {
            Vector256<ulong> both = (high - Vector256.Create(lowB[j])) & (Vector256.Create(highB[j]) - low) & guards;
            uint meeting = Vector256.Equals(both, guards).ExtractMostSignificantBits();
            Vector256.Shuffle(pairs.AsInt32(), fronts[meeting]).AsUInt64().CopyTo(output, count);
            count += BitOperations.PopCount(meeting);
            pairs += Vector256<ulong>.One;
        }

        return count;
    }

    private static Vector256<int>[] Fronts()
    {
        var places = new Vector256<int>[1 << TriangleTree.Branching];
        Span<int> from = stackalloc int[2 * TriangleTree.Branching];
        for (int set = 0; set < places.Length; set++)
        {
            from.Clear();
            int next = 0;
            for (int i = 0; i < TriangleTree.Branching; i++)
            {
                if ((set & (1 << i)) != 0)
                {
                    from[next++] = 2 * i;
                    from[next++] = (2 * i) + 1;
                }
            }

            places[set] = Vector256.Create<int>(from);
        }

        return places;
    }
}
#endif
