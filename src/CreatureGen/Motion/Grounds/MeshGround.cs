using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Grounds;

namespace CreatureGen.Motion;

/// <summary>A triangle mesh as ground, hit from its front. Triangles lie in a tree of boxes, so large meshes cost little.</summary>
/// <remarks>Based on: T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection" (1997).</remarks>
public sealed class MeshGround : IGround, ITrustedGround
{
    private const int LeafSize = 4;
    private const int Depth = 64;

    // A ray that goes along a triangle as closely as that does not meet it: single precision knows no more.
    private const double GrazingSine = 1e-6;

    private readonly Vector3[] positions;
    private readonly int[] triangles;
    private readonly int[] surfaces;
    private readonly Node[] nodes;
    private readonly int[] order;
    private int nodeCount;

    /// <summary>Takes a mesh.</summary>
    /// <param name="positions">World space, metres; copied.</param>
    /// <param name="triangles">Indices, three for each triangle, counter-clockwise seen from outside; copied.</param>
    /// <param name="surfaces">What each triangle is made of, one each; or empty for 0.</param>
    /// <exception cref="ArgumentException">An index is out of range, a position is not finite, or counts do not fit.</exception>
    public MeshGround(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<int> surfaces = default)
    {
        int count = triangles.Length / 3;
        if (triangles.Length % 3 != 0 || (surfaces.Length != 0 && surfaces.Length != count))
        {
            throw new ArgumentException(FormattableString.Invariant($"{triangles.Length} indices and {surfaces.Length} surfaces; expected three indices, and one surface or none, for each triangle"), nameof(triangles));
        }

        foreach (Vector3 p in positions)
        {
            Finite.Require(p, nameof(positions));
        }

        foreach (int index in triangles)
        {
            if ((uint)index >= (uint)positions.Length)
            {
                throw new ArgumentException(FormattableString.Invariant($"index {index}; expected 0..{positions.Length - 1}"), nameof(triangles));
            }
        }

        this.positions = positions.ToArray();
        this.triangles = triangles.ToArray();
        this.surfaces = surfaces.ToArray();
        order = new int[count];
        for (int i = 0; i < count; i++)
        {
            order[i] = i;
        }

        nodes = new Node[Math.Max(2 * count, 1)];
        if (count > 0)
        {
            Build(0, count);
        }
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (order.Length == 0 || !(Finite.Is(origin) && Finite.Is(direction) && distance >= 0f))
        {
            return false;
        }

        Span<int> stack = stackalloc int[Depth];
        int top = 0;
        stack[top++] = 0;
        float nearest = distance;
        int best = -1;
        while (top > 0)
        {
            ref readonly Node node = ref nodes[stack[--top]];
            if (!node.IsHit(origin, direction, nearest))
            {
                continue;
            }

            if (node.Count == 0)
            {
                stack[top++] = node.First;
                stack[top++] = node.Second;
                continue;
            }

            for (int i = node.First; i < node.First + node.Count; i++)
            {
                float t = Distance(order[i], origin, direction);
                if (t >= 0f && t <= nearest && (t < nearest || best < 0 || order[i] < best))
                {
                    nearest = t;
                    best = order[i];
                }
            }
        }

        if (best < 0)
        {
            return false;
        }

        Vector3 a = positions[triangles[3 * best]];
        Vector3 normal = Vec.Normalize(Vec.Cross(positions[triangles[(3 * best) + 1]] - a, positions[triangles[(3 * best) + 2]] - a), Vector3.UnitY);
        hit = new GroundHit(origin + (direction * nearest), normal, surfaces.Length == 0 ? 0 : surfaces[best]);
        return true;
    }

    /// <summary>Distance to a triangle along a ray, or −1.</summary>
    private float Distance(int triangle, Vector3 origin, Vector3 direction)
    {
        Vector3 a = positions[triangles[3 * triangle]];
        Vector3 ab = positions[triangles[(3 * triangle) + 1]] - a;
        Vector3 ac = positions[triangles[(3 * triangle) + 2]] - a;
        Vector3 p = Vec.Cross(direction, ac);
        float determinant = Vec.Dot(ab, p);

        // The sine of the angle between ray and triangle, for triangles of any size.
        double sides = (double)Vec.LengthSquared(ab) * Vec.LengthSquared(ac);
        if (!(determinant > 0f && (double)determinant * determinant > GrazingSine * GrazingSine * sides))
        {
            return -1f;
        }

        Vector3 s = origin - a;
        float u = Vec.Dot(s, p);
        Vector3 q = Vec.Cross(s, ab);
        float v = Vec.Dot(direction, q);
        float slack = 1e-6f * determinant;
        return u < -slack || v < -slack || u + v > determinant + slack ? -1f : Vec.Dot(ac, q) / determinant;
    }

    /// <summary>Builds the node of a range of triangles: halves along the longest side of their centres.</summary>
    private int Build(int start, int count)
    {
        int index = nodeCount++;
        var min = new Vector3(float.MaxValue);
        var max = new Vector3(float.MinValue);
        var minCentre = new Vector3(float.MaxValue);
        var maxCentre = new Vector3(float.MinValue);
        for (int i = start; i < start + count; i++)
        {
            for (int k = 0; k < 3; k++)
            {
                Vector3 p = positions[triangles[(3 * order[i]) + k]];
                min = Vec.Min(min, p);
                max = Vec.Max(max, p);
            }

            Vector3 centre = Centre(order[i]);
            minCentre = Vec.Min(minCentre, centre);
            maxCentre = Vec.Max(maxCentre, centre);
        }

        if (count <= LeafSize)
        {
            nodes[index] = new Node(min, max, start, 0, count);
            return index;
        }

        Vector3 size = maxCentre - minCentre;
        int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        float[] keys = new float[count];
        for (int i = 0; i < count; i++)
        {
            Vector3 centre = Centre(order[start + i]);
            keys[i] = axis == 0 ? centre.X : axis == 1 ? centre.Y : centre.Z;
        }

        SortRange(keys, start, count);
        int half = count / 2;
        int first = Build(start, half);
        int second = Build(start + half, count - half);
        nodes[index] = new Node(min, max, first, second, 0);
        return index;
    }

    private void SortRange(float[] keys, int start, int count)
    {
        int[] range = new int[count];
        Array.Copy(order, start, range, 0, count);
        Array.Sort(keys, range);
        Array.Copy(range, 0, order, start, count);
    }

    private Vector3 Centre(int triangle) =>
        (positions[triangles[3 * triangle]] + positions[triangles[(3 * triangle) + 1]] + positions[triangles[(3 * triangle) + 2]]) / 3f;

    /// <summary>A box with two children, or with triangles.</summary>
    private readonly struct Node
    {
        private readonly Vector3 min;
        private readonly Vector3 max;

        public Node(Vector3 min, Vector3 max, int first, int second, int count)
        {
            this.min = min;
            this.max = max;
            First = first;
            Second = second;
            Count = count;
        }

        /// <summary>First child, or first triangle of a leaf.</summary>
        public int First { get; }

        public int Second { get; }

        /// <summary>Number of triangles of a leaf; 0 for a node with children.</summary>
        public int Count { get; }

        public bool IsHit(Vector3 origin, Vector3 direction, float distance)
        {
            float enter = 0f;
            float leave = distance;
            return Slab(origin.X, direction.X, min.X, max.X, ref enter, ref leave)
                && Slab(origin.Y, direction.Y, min.Y, max.Y, ref enter, ref leave)
                && Slab(origin.Z, direction.Z, min.Z, max.Z, ref enter, ref leave);
        }

        private static bool Slab(float origin, float direction, float min, float max, ref float enter, ref float leave)
        {
            if (Math.Abs(direction) < 1e-12f)
            {
                return origin >= min && origin <= max;
            }

            float a = (min - origin) / direction;
            float b = (max - origin) / direction;
            enter = Math.Max(enter, Math.Min(a, b));
            leave = Math.Min(leave, Math.Max(a, b));
            return enter <= leave * 1.000001f + 1e-6f;
        }
    }
}
