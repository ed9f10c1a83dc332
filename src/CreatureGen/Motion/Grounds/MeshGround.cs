using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Grounds;

namespace CreatureGen.Motion;

/// <summary>A triangle mesh as ground, hit from its front. Triangles lie in a tree of boxes, so large meshes cost little.</summary>
/// <remarks>Based on: T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection" (1997).</remarks>
public sealed class MeshGround : IGround, ITrustedGround
{
    // A ray that goes along a triangle as closely as that does not meet it: single precision knows no more.
    private const double GrazingSine = 1e-6;

    private readonly BoxTree tree;
    private readonly int[] surfaces;

    // Corners of the triangles in the tree's order, three for each.
    private readonly Vector3[] corners;

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

        this.surfaces = surfaces.ToArray();
        tree = BoxTree.Of(positions, triangles);
        corners = new Vector3[3 * count];
        for (int i = 0; i < count; i++)
        {
            ReadOnlySpan<int> triangle = triangles.Slice(3 * tree.Order[i], 3);
            for (int k = 0; k < 3; k++)
            {
                corners[(3 * i) + k] = positions[triangle[k]];
            }
        }
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (corners.Length == 0 || !(Finite.Is(origin) && Finite.Is(direction) && distance >= 0f))
        {
            return false;
        }

        ReadOnlySpan<BoxNode> nodes = tree.Nodes;
        Span<(int Node, float Entry)> stack = stackalloc (int, float)[BoxTree.MaxDepth];
        var ray = new BoxRay(origin, direction);
        float nearest = distance;
        int best = -1;
        int top = 0;
        stack[top++] = (0, ray.Enters(nodes[0], nearest));
        while (top > 0)
        {
            (int node, float entry) = stack[--top];

            // Down to a leaf, the nearer child first: what it hits spares most of the farther one.
            while (entry <= nearest && nodes[node].Count == 0)
            {
                int near = node + 1;
                int far = nodes[node].First;
                entry = ray.Enters(nodes[near], nearest);
                float farEntry = ray.Enters(nodes[far], nearest);
                if (farEntry < entry)
                {
                    (near, far) = (far, near);
                    (entry, farEntry) = (farEntry, entry);
                }

                if (farEntry <= nearest)
                {
                    stack[top++] = (far, farEntry);
                }

                node = near;
            }

            if (entry <= nearest)
            {
                HitLeaf(nodes[node], origin, direction, ref nearest, ref best);
            }
        }

        if (best < 0)
        {
            return false;
        }

        Vector3 a = corners[3 * best];
        Vector3 normal = Vec.Normalize(Vec.Cross(corners[(3 * best) + 1] - a, corners[(3 * best) + 2] - a), Vector3.UnitY);
        hit = new GroundHit(origin + (direction * nearest), normal, surfaces.Length == 0 ? 0 : surfaces[tree.Order[best]]);
        return true;
    }

    /// <summary>Holds the ray against the triangles of a leaf; of equally near ones the first of the mesh counts.</summary>
    private void HitLeaf(in BoxNode leaf, Vector3 origin, Vector3 direction, ref float nearest, ref int best)
    {
        for (int i = leaf.First; i < leaf.First + leaf.Count; i++)
        {
            float t = Distance(i, origin, direction);
            if (t >= 0f && t <= nearest && (t < nearest || best < 0 || tree.Order[i] < tree.Order[best]))
            {
                nearest = t;
                best = i;
            }
        }
    }

    /// <summary>Distance to a triangle along a ray, or −1.</summary>
    private float Distance(int triangle, Vector3 origin, Vector3 direction)
    {
        Vector3 a = corners[3 * triangle];
        Vector3 ab = corners[(3 * triangle) + 1] - a;
        Vector3 ac = corners[(3 * triangle) + 2] - a;
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
}
