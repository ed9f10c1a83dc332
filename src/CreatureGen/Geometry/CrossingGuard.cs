using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Says of triangles that a step of a reduction would move whether they would cut through others of their piece.</summary>
/// <remarks>
/// Triangles, of mirrored pieces those of the left side alone, lie in a <see cref="TriangleTree"/>, whose boxes are widened as they move; once a third of them has gone, the tree is built anew of what is left. It is asked in a third of the time of a grid of cells: a triangle lies in it once, and
/// boxes are met without branches. What counts as a crossing is said by <see cref="TriangleCrossing"/>.
/// </remarks>
internal sealed class CrossingGuard : IDisposable
{
    /// <summary>The tree of the last guard that was disposed of: its lists are large, and as long as those of the next one.</summary>
    [ThreadStatic]
    private static TriangleTree? spareTree;

    /// <summary>Part of the triangles that is left when the tree is built anew.</summary>
    private const double Worn = 0.66;

    private readonly CollapsingMesh surface;
    private readonly Vector3[] positions;
    private readonly int[] points;
    private readonly int[] pieceOf;
    private readonly bool[] isImage;
    private readonly double tolerance;
    private readonly TriangleTree tree;
    private readonly int[] slotOf;

    // The triangles in the tree, in the order in which they were given to it, and their corners then.
    private readonly int[] entered;
    private readonly int[] corners;

    // What is near a step: its slots, and their boxes side by side.
    private int[] nearby = new int[64];
    private ulong[] nearbyLow = new ulong[64];
    private ulong[] nearbyHigh = new ulong[64];
    private int nearbyCount;
    private int worn;

    /// <summary>Takes the surface as it is.</summary>
    /// <param name="surface">What is reduced.</param>
    /// <param name="positions">Place of each point; points do not move.</param>
    /// <param name="points">The point of each corner, as the reduction changes them.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    /// <param name="isImage">The triangles that are images of others, on the other side of the plane of symmetry, and never asked about. Both sides have only the plane in common, so that they are met by none.</param>
    public CrossingGuard(CollapsingMesh surface, Vector3[] positions, int[] points, int[] pieceOf, bool[] isImage)
    {
        this.surface = surface;
        this.positions = positions;
        this.points = points;
        this.pieceOf = pieceOf;
        this.isImage = isImage;
        tolerance = Tolerance.CrossingLengthPerDiagonal * PointBounds.Of(positions).Diagonal;
        tree = spareTree ?? new TriangleTree();
        spareTree = null;
        slotOf = new int[points.Length / 3];
        entered = new int[points.Length / 3];
        corners = new int[points.Length];
        Build();
    }

    /// <summary>Whether one of the triangles cuts through another of its piece with which it shares no point.</summary>
    /// <param name="moved">The triangles; all have <paramref name="pulledTo"/> for a corner.</param>
    /// <param name="pulled">The point that they were pulled from.</param>
    /// <param name="pulledTo">The point that they were pulled to.</param>
    public bool Cross(List<int> moved, int pulled, int pulledTo)
    {
        if (moved.Count == 0)
        {
            return false;
        }

        Gather(moved, pulled, pulledTo);
        foreach (int t in moved)
        {
            if (nearbyCount > 0 && CrossesNearby(t))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Whether one of the triangles, where it reaches across the plane of symmetry, cuts through the mirror image of another or of its own.</summary>
    /// <param name="moved">The triangles.</param>
    /// <param name="twin">The mirror image of each point.</param>
    public bool CrossImages(List<int> moved, int[] twin)
    {
        foreach (int t in moved)
        {
            int a = points[3 * t], b = points[(3 * t) + 1], c = points[(3 * t) + 2];
            if (Math.Min(positions[a].X, Math.Min(positions[b].X, positions[c].X)) >= 0f)
            {
                continue;
            }

            foreach (int u in moved)
            {
                int i = twin[points[3 * u]], j = twin[points[(3 * u) + 1]], k = twin[points[(3 * u) + 2]];
                if (!Connected(a, b, c, i, j, k) && TriangleCrossing.Cross(positions[a], positions[b], positions[c], positions[i], positions[j], positions[k], tolerance))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>Takes note of where triangles are now, and of those that are no more.</summary>
    public void Note(List<int> moved, List<int> lost)
    {
        foreach (int t in lost)
        {
            if (slotOf[t] >= 0)
            {
                tree.Remove(slotOf[t]);
            }
        }

        foreach (int t in moved)
        {
            if (slotOf[t] >= 0)
            {
                tree.Move(slotOf[t], points[3 * t], points[(3 * t) + 1], points[(3 * t) + 2]);
            }
        }

        if (surface.Triangles < worn)
        {
            Build();
        }
    }

    /// <inheritdoc/>
    public void Dispose() => spareTree = tree;

    private void Build()
    {
        int count = 0;
        for (int t = 0; t < slotOf.Length; t++)
        {
            if (!surface.IsGone(t) && !isImage[t])
            {
                corners[3 * count] = points[3 * t];
                corners[(3 * count) + 1] = points[(3 * t) + 1];
                corners[(3 * count) + 2] = points[(3 * t) + 2];
                entered[count++] = t;
            }
        }

        tree.Build(positions, corners.AsSpan(0, 3 * count));
        Array.Fill(slotOf, -1);
        ReadOnlySpan<int> order = tree.Order;
        for (int slot = 0; slot < order.Length; slot++)
        {
            slotOf[entered[order[slot]]] = slot;
        }

        worn = (int)(Worn * surface.Triangles);
    }

    /// <summary>Lists the slots that the box of all moved triangles meets, without those that share a point with all of these: one search instead of one for each triangle, which halves the time of a reduction.</summary>
    private void Gather(List<int> moved, int pulled, int pulledTo)
    {
        (ulong low, ulong high) = BoxOf(moved[0]);
        high = BoxCode.Bare(high);
        foreach (int t in moved)
        {
            (ulong lower, ulong higher) = BoxOf(t);
            low = BoxCode.Min(low, lower);
            high = BoxCode.Max(high, BoxCode.Bare(higher));
        }

        ReadOnlySpan<int> met = tree.Overlapping(low, BoxCode.Guard(high));
        if (nearby.Length < met.Length)
        {
            nearby = new int[2 * met.Length];
            nearbyLow = new ulong[nearby.Length];
            nearbyHigh = new ulong[nearby.Length];
        }

        nearbyCount = 0;
        int piece = pieceOf[pulledTo];
        ReadOnlySpan<int> ends = tree.Corners;
        ReadOnlySpan<ulong> lows = tree.Low(0);
        ReadOnlySpan<ulong> highs = tree.High(0);
        foreach (int slot in met)
        {
            // The tree is told of a step when it is taken: what the step moves or takes away still has the point there that was pulled.
            int i = ends[3 * slot], j = ends[(3 * slot) + 1], k = ends[(3 * slot) + 2];
            if (i != pulled && j != pulled && k != pulled && i != pulledTo && j != pulledTo && k != pulledTo && pieceOf[i] == piece)
            {
                nearby[nearbyCount] = slot;
                nearbyLow[nearbyCount] = lows[slot];
                nearbyHigh[nearbyCount++] = highs[slot];
            }
        }
    }

    private bool CrossesNearby(int t)
    {
        int a = points[3 * t], b = points[(3 * t) + 1], c = points[(3 * t) + 2];
        (ulong low, ulong high) = BoxOf(t);
        var plane = new PlaneSide(positions[a], positions[b], positions[c], tolerance);
        ReadOnlySpan<int> ends = tree.Corners;
        ReadOnlySpan<ulong> lows = nearbyLow.AsSpan(0, nearbyCount);
        ReadOnlySpan<ulong> highs = nearbyHigh.AsSpan(0, lows.Length);
        for (int n = 0; n < lows.Length; n++)
        {
            if (BoxCode.Overlap(low, high, lows[n], highs[n]) == 0)
            {
                continue;
            }

            int slot = nearby[n];
            int i = ends[3 * slot], j = ends[(3 * slot) + 1], k = ends[(3 * slot) + 2];
            if (!Connected(a, b, c, i, j, k) && !plane.IsOneOf(positions[i], positions[j], positions[k]) && TriangleCrossing.Cross(positions[a], positions[b], positions[c], positions[i], positions[j], positions[k], tolerance))
            {
                return true;
            }
        }

        return false;
    }

    private static bool Connected(int a, int b, int c, int i, int j, int k) => i == a || i == b || i == c || j == a || j == b || j == c || k == a || k == b || k == c;

    private (ulong Low, ulong High) BoxOf(int t) => tree.BoxOf(points[3 * t], points[(3 * t) + 1], points[(3 * t) + 2]);

    /// <summary>The plane of a triangle, without the length of its normal, whose root costs most of the test of two triangles.</summary>
    private readonly struct PlaneSide
    {
        private readonly Vector3 corner;
        private readonly double x;
        private readonly double y;
        private readonly double z;
        private readonly double margin;

        public PlaneSide(Vector3 a, Vector3 b, Vector3 c, double tolerance)
        {
            double ux = (double)b.X - a.X, uy = (double)b.Y - a.Y, uz = (double)b.Z - a.Z;
            double vx = (double)c.X - a.X, vy = (double)c.Y - a.Y, vz = (double)c.Z - a.Z;
            corner = a;
            x = (uy * vz) - (uz * vy);
            y = (uz * vx) - (ux * vz);
            z = (ux * vy) - (uy * vx);
            margin = tolerance * (Math.Abs(x) + Math.Abs(y) + Math.Abs(z));
        }

        /// <summary>Whether three corners certainly lie on one side of the plane.</summary>
        public bool IsOneOf(Vector3 a, Vector3 b, Vector3 c)
        {
            double da = Distance(a), db = Distance(b), dc = Distance(c);
            return (da > margin && db > margin && dc > margin) || (da < -margin && db < -margin && dc < -margin);
        }

        private double Distance(Vector3 p) => (((double)p.X - corner.X) * x) + (((double)p.Y - corner.Y) * y) + (((double)p.Z - corner.Z) * z);
    }
}
