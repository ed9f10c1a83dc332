using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Grounds;

/// <summary>Triangles in a tree of boxes that halves them along the longest side of their centres. Nothing but its arrays is allocated.</summary>
/// <remarks>Halves are found by C. A. R. Hoare, "Algorithm 65: Find" (1961): neither half needs to be in order.</remarks>
internal sealed class BoxTree
{
    /// <summary>Boxes that lie within one another, at most: each has half the triangles of the one around it.</summary>
    public const int MaxDepth = 64;

    private const int LeafSize = 4;

    private readonly BoxNode[] nodes;
    private readonly int[] order;

    private BoxTree(BoxNode[] nodes, int[] order)
    {
        this.nodes = nodes;
        this.order = order;
    }

    /// <summary>The boxes; the first holds all others. None without triangles.</summary>
    public ReadOnlySpan<BoxNode> Nodes => nodes;

    /// <summary>The numbers of the triangles, those of a leaf beside each other.</summary>
    public ReadOnlySpan<int> Order => order;

    /// <summary>The tree of a mesh.</summary>
    /// <param name="positions">Finite, metres.</param>
    /// <param name="triangles">Indices, three for each triangle.</param>
    public static BoxTree Of(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles)
    {
        int count = triangles.Length / 3;
        var centres = new Centre[count];
        for (int i = 0; i < count; i++)
        {
            centres[i] = new Centre((positions[triangles[3 * i]] + positions[triangles[(3 * i) + 1]] + positions[triangles[(3 * i) + 2]]) / 3f, i);
        }

        // Leaves hold two triangles or more, but for a tree of one.
        var nodes = new BoxNode[Math.Max(count, 1)];
        if (count > 0)
        {
            var builder = new Builder(positions, triangles, centres, nodes);
            builder.Grow(0, count);
        }

        return new BoxTree(nodes, Array.ConvertAll(centres, centre => centre.Triangle));
    }

    private ref struct Builder
    {
        private readonly ReadOnlySpan<Vector3> positions;
        private readonly ReadOnlySpan<int> triangles;
        private readonly Span<Centre> centres;
        private readonly Span<BoxNode> nodes;
        private int nodeCount;

        public Builder(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, Span<Centre> centres, Span<BoxNode> nodes)
        {
            this.positions = positions;
            this.triangles = triangles;
            this.centres = centres;
            this.nodes = nodes;
            nodeCount = 0;
        }

        /// <summary>Makes the box of a range of triangles, and all within it; gives its number.</summary>
        public int Grow(int start, int count)
        {
            int index = nodeCount++;
            Span<Centre> members = centres.Slice(start, count);
            if (count <= LeafSize)
            {
                nodes[index] = Leaf(members, start);
                return index;
            }

            int half = count / 2;
            Partition(members, half, LongestAxis(members));
            int first = Grow(start, half);
            int second = Grow(start + half, count - half);
            nodes[index] = new BoxNode(Vec.Min(nodes[first].Min, nodes[second].Min), Vec.Max(nodes[first].Max, nodes[second].Max), second, 0);
            return index;
        }

        private readonly BoxNode Leaf(ReadOnlySpan<Centre> members, int start)
        {
            var min = new Vector3(float.MaxValue);
            var max = new Vector3(float.MinValue);
            foreach (Centre member in members)
            {
                for (int k = 0; k < 3; k++)
                {
                    Vector3 corner = positions[triangles[(3 * member.Triangle) + k]];
                    min = Vec.Min(min, corner);
                    max = Vec.Max(max, corner);
                }
            }

            return new BoxNode(min, max, start, members.Length);
        }

        private static int LongestAxis(ReadOnlySpan<Centre> members)
        {
            Vector3 min = members[0].Point;
            Vector3 max = min;
            foreach (ref readonly Centre member in members)
            {
                min = Vec.Min(min, member.Point);
                max = Vec.Max(max, member.Point);
            }

            Vector3 size = max - min;
            return size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        }

        /// <summary>Puts the members with the lowest centres along an axis before all others.</summary>
        private static void Partition(Span<Centre> members, int lowest, int axis)
        {
            while (members.Length > 1)
            {
                float pivot = members[members.Length / 2].Along(axis);
                int left = 0;
                int right = members.Length - 1;
                while (left <= right)
                {
                    while (members[left].Along(axis) < pivot)
                    {
                        left++;
                    }

                    while (members[right].Along(axis) > pivot)
                    {
                        right--;
                    }

                    if (left <= right)
                    {
                        (members[left], members[right]) = (members[right], members[left]);
                        left++;
                        right--;
                    }
                }

                if (lowest <= right)
                {
                    members = members.Slice(0, right + 1);
                }
                else if (lowest >= left)
                {
                    lowest -= left;
                    members = members.Slice(left);
                }
                else
                {
                    return;
                }
            }
        }
    }

    private readonly struct Centre
    {
        public readonly Vector3 Point;
        public readonly int Triangle;

        public Centre(Vector3 point, int triangle)
        {
            Point = point;
            Triangle = triangle;
        }

        public float Along(int axis) => axis == 0 ? Point.X : axis == 1 ? Point.Y : Point.Z;
    }
}
