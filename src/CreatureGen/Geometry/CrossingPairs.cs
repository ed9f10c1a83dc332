using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>The crossing pairs of a surface while parts of it move. Buffers grow and are kept; for one thread at a time.</summary>
/// <remarks>
/// Looks only where crossings can be: at the left side, and on the right at the images of those pairs that had to be tried on the left; and after a repair round at what moved, and what is near that.
/// Where the sides are no exact images of one another both are searched. The pairs are those of a search of the whole.
/// </remarks>
internal sealed class CrossingPairs
{
    private readonly SelfIntersectionWorkspace workspace = new();
    private readonly List<(int First, int Second)> found = new();
    private readonly List<(int First, int Second)> pairs = new();
    private readonly TriangleImages images = new();
    private int[] chosen = Array.Empty<int>();
    private int[] corners = Array.Empty<int>();
    private bool[] still = Array.Empty<bool>();
    private int count;
    private PointBounds searched;

    /// <summary>The pairs, ascending by their first and then their second triangle; the first is the lower of the two.</summary>
    public List<(int First, int Second)> Pairs => pairs;

    /// <summary>Finds the pairs of a whole surface and gives their number.</summary>
    /// <param name="positions">One per vertex, finite.</param>
    /// <param name="triangles">Vertex indices, three per triangle, in range.</param>
    /// <param name="mirror">For each vertex its mirror image in the plane x = 0; empty for a surface without symmetry.</param>
    public int Find(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<int> mirror)
    {
        pairs.Clear();
        searched = PointBounds.Of(positions);
        images.Clear();
        if (mirror.IsEmpty || !AreSidesApart(positions, triangles))
        {
            return SelfIntersection.Find(positions, triangles, pairs, workspace);
        }

        // Both sides have only the plane in common: no triangle of one crosses one of the other, and where the left is clean the right is.
        ChooseSide(positions, triangles, 1);
        AddChosen(positions, default);
        if (pairs.Count > 0)
        {
            images.Find(positions, triangles, mirror);
            if (!AddImages(positions, triangles, mirror))
            {
                ChooseSide(positions, triangles, -1);
                AddChosen(positions, default);
            }

            pairs.Sort();
        }

        return pairs.Count;
    }

    /// <summary>Finds the pairs anew after some points have moved since the last search of the same surface, and gives their number.</summary>
    /// <param name="positions">One per vertex, finite.</param>
    /// <param name="triangles">Vertex indices, three per triangle, in range.</param>
    /// <param name="mirror">For each vertex its mirror image in the plane x = 0; empty for a surface without symmetry.</param>
    /// <param name="moved">Which points have moved.</param>
    public int FindAgain(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<int> mirror, ReadOnlySpan<bool> moved)
    {
        PointBounds bounds = PointBounds.Of(positions);
        if (bounds.Min != searched.Min || bounds.Max != searched.Max)
        {
            // The tolerance is a part of the diagonal: all pairs may have changed.
            return Find(positions, triangles, mirror);
        }

        for (int i = pairs.Count - 1; i >= 0; i--)
        {
            if (Moves(triangles, pairs[i].First, moved) || Moves(triangles, pairs[i].Second, moved))
            {
                pairs.RemoveAt(i);
            }
        }

        bool onLeft = images.Hold(positions, mirror, moved) && AreSidesApart(positions, triangles);
        int before = pairs.Count;
        ChooseNear(positions, triangles, moved, onLeft);
        AddChosen(positions, still.AsSpan(0, count));
        if (onLeft && !AddImages(positions, triangles, mirror))
        {
            pairs.RemoveRange(before, pairs.Count - before);
            ChooseNear(positions, triangles, moved, false);
            AddChosen(positions, still.AsSpan(0, count));
        }

        pairs.Sort();
        return pairs.Count;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Moves(ReadOnlySpan<int> triangles, int t, ReadOnlySpan<bool> moved) => moved[triangles[3 * t]] || moved[triangles[(3 * t) + 1]] || moved[triangles[(3 * t) + 2]];

    /// <summary>Whether no triangle reaches across the plane x = 0 or lies in it.</summary>
    private static bool AreSidesApart(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        for (int i = 0; i < triangles.Length; i += 3)
        {
            float a = positions[triangles[i]].X;
            float b = positions[triangles[i + 1]].X;
            float c = positions[triangles[i + 2]].X;
            if ((a > 0f || b > 0f || c > 0f) == (a < 0f || b < 0f || c < 0f))
            {
                return false;
            }
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool IsOnSide(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, int t, int sign) =>
        sign * positions[triangles[3 * t]].X > 0f || sign * positions[triangles[(3 * t) + 1]].X > 0f || sign * positions[triangles[(3 * t) + 2]].X > 0f;

    private void ChooseSide(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, int sign)
    {
        Clear(triangles.Length);
        for (int t = 0; t < triangles.Length / 3; t++)
        {
            if (IsOnSide(positions, triangles, t, sign))
            {
                Choose(triangles, t);
            }
        }
    }

    /// <summary>Chooses the triangles that meet the box of the moved ones of the left or that of the right; where that is asked for, those of the left alone.</summary>
    private void ChooseNear(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<bool> moved, bool onLeft)
    {
        Vector3 leftLow = new(float.MaxValue), leftHigh = new(float.MinValue), rightLow = leftLow, rightHigh = leftHigh;
        for (int t = 0; t < triangles.Length / 3; t++)
        {
            if (Moves(triangles, t, moved))
            {
                (Vector3 low, Vector3 high) = BoxOf(positions, triangles, t);
                if (low.X + high.X >= 0f)
                {
                    leftLow = Vec.Min(leftLow, low);
                    leftHigh = Vec.Max(leftHigh, high);
                }
                else
                {
                    rightLow = Vec.Min(rightLow, low);
                    rightHigh = Vec.Max(rightHigh, high);
                }
            }
        }

        Clear(triangles.Length);
        for (int t = 0; t < triangles.Length / 3; t++)
        {
            if (onLeft && !IsOnSide(positions, triangles, t, 1))
            {
                continue;
            }

            (Vector3 low, Vector3 high) = BoxOf(positions, triangles, t);
            if (Meet(low, high, leftLow, leftHigh) || Meet(low, high, rightLow, rightHigh))
            {
                still[count] = !Moves(triangles, t, moved);
                Choose(triangles, t);
            }
        }
    }

    private static (Vector3 Low, Vector3 High) BoxOf(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, int t)
    {
        Vector3 a = positions[triangles[3 * t]], b = positions[triangles[(3 * t) + 1]], c = positions[triangles[(3 * t) + 2]];
        return (Vec.Min(a, Vec.Min(b, c)), Vec.Max(a, Vec.Max(b, c)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool Meet(Vector3 lowA, Vector3 highA, Vector3 lowB, Vector3 highB) =>
        lowA.X <= highB.X && highA.X >= lowB.X && lowA.Y <= highB.Y && highA.Y >= lowB.Y && lowA.Z <= highB.Z && highA.Z >= lowB.Z;

    private void Clear(int room)
    {
        count = 0;
        if (corners.Length < room)
        {
            corners = new int[room];
            chosen = new int[room / 3];
            still = new bool[room / 3];
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Choose(ReadOnlySpan<int> triangles, int t)
    {
        triangles.Slice(3 * t, 3).CopyTo(corners.AsSpan(3 * count));
        chosen[count++] = t;
    }

    /// <summary>Adds the pairs of what is chosen, without those of two triangles that are still.</summary>
    private void AddChosen(ReadOnlySpan<Vector3> positions, ReadOnlySpan<bool> still)
    {
        workspace.Find(positions, corners.AsSpan(0, 3 * count), found, null, still);
        foreach ((int first, int second) in found)
        {
            pairs.Add((chosen[first], chosen[second]));
        }
    }

    /// <summary>Adds the pairs of the right: of what was tried on the left, those of which the images cross. False when some have no image.</summary>
    private bool AddImages(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<int> mirror)
    {
        foreach ((int first, int second) in workspace.Tried)
        {
            int one = images.Of(chosen[first], triangles, mirror);
            int other = images.Of(chosen[second], triangles, mirror);
            if (one < 0 || other < 0)
            {
                return false;
            }

            if (workspace.Cross(positions, triangles.Slice(3 * one, 3), triangles.Slice(3 * other, 3)))
            {
                pairs.Add((Math.Min(one, other), Math.Max(one, other)));
            }
        }

        return true;
    }
}
