using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Says of triangles that a step of a reduction would move whether they would cut through others of their piece.</summary>
/// <remarks>
/// Triangles lie in the cells of a grid that their boxes touch. Those that have moved are entered again and not taken out of where they were; once there are too many of these, the grid
/// is laid anew, with cells for the triangles as large as they have become. What counts as a crossing is said by <see cref="TriangleCrossing"/>.
/// Based on: M. Teschner et al. 2003, "Optimized spatial hashing for collision detection of deformable objects".
/// </remarks>
internal sealed class CrossingGuard
{
    /// <summary>Side of a cell in mean diagonals of the triangles' boxes.</summary>
    private const double CellSize = 1.4;

    /// <summary>Most cells along the diagonal of the surface.</summary>
    private const int MaxCells = 256;

    /// <summary>How many times as many entries as at first there may be.</summary>
    private const double MaxGrowth = 1.6;

    private readonly CollapsingMesh surface;
    private readonly Vector3[] positions;
    private readonly int[] points;
    private readonly int[] pieceOf;
    private readonly double tolerance;
    private readonly double diagonal;
    private readonly Vector3 origin;
    private readonly Box[] boxes;
    private readonly int[] heads;
    private readonly List<int> nearby = new();
    private Entry[] chain;
    private int entries;
    private int limit;
    private float perCell;
    private int stamp;

    /// <summary>Takes the surface as it is.</summary>
    /// <param name="surface">What is reduced.</param>
    /// <param name="positions">Place of each point.</param>
    /// <param name="points">The point of each corner, as the reduction changes them.</param>
    /// <param name="pieceOf">The piece of each point.</param>
    public CrossingGuard(CollapsingMesh surface, Vector3[] positions, int[] points, int[] pieceOf)
    {
        this.surface = surface;
        this.positions = positions;
        this.points = points;
        this.pieceOf = pieceOf;
        PointBounds bounds = PointBounds.Of(positions);
        diagonal = bounds.Diagonal;
        tolerance = Tolerance.CrossingLengthPerDiagonal * diagonal;
        origin = bounds.Min;
        int count = points.Length / 3;
        boxes = new Box[count];
        chain = new Entry[16 * count];
        int slots = 64;
        while (slots < 8 * count)
        {
            slots *= 2;
        }

        heads = new int[slots];
        for (int t = 0; t < count; t++)
        {
            boxes[t] = BoxOf(t);
        }

        LayGrid();
    }

    /// <summary>Whether one of the triangles cuts through another of its piece with which it shares no point.</summary>
    /// <param name="moved">The triangles; all have <paramref name="pulledTo"/> for a corner.</param>
    /// <param name="pulledTo">The point that they were pulled to.</param>
    public bool Cross(List<int> moved, int pulledTo)
    {
        if (moved.Count == 0)
        {
            return false;
        }

        Gather(moved, pulledTo);
        foreach (int t in moved)
        {
            if (nearby.Count > 0 && CrossesNearby(t))
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

    /// <summary>Takes note of where triangles are now.</summary>
    public void Note(List<int> moved)
    {
        foreach (int t in moved)
        {
            boxes[t] = BoxOf(t);
            Enter(t);
        }

        if (entries > limit)
        {
            LayGrid();
        }
    }

    private void LayGrid()
    {
        double sizes = 0;
        int live = 0;
        for (int t = 0; t < boxes.Length; t++)
        {
            sizes += surface.IsGone(t) ? 0 : Vec.Distance(boxes[t].Low, boxes[t].High);
            live += surface.IsGone(t) ? 0 : 1;
        }

        double cell = Math.Max(CellSize * sizes / Math.Max(live, 1), diagonal / MaxCells);
        perCell = cell > 0 ? (float)(1 / cell) : 1f;
        Array.Fill(heads, -1);
        entries = 0;
        for (int t = 0; t < boxes.Length; t++)
        {
            if (!surface.IsGone(t))
            {
                Enter(t);
            }
        }

        limit = (int)(MaxGrowth * entries) + 64;
    }

    /// <summary>Lists the triangles that the box of all moved ones meets, without those that share the point with all of these: one way through the grid instead of one for each triangle, which halves the time of a reduction.</summary>
    private void Gather(List<int> moved, int pulledTo)
    {
        Box all = BoxOf(moved[0]);
        foreach (int t in moved)
        {
            Box box = BoxOf(t);
            all.Low = Vec.Min(all.Low, box.Low);
            all.High = Vec.Max(all.High, box.High);
        }

        nearby.Clear();
        int piece = pieceOf[pulledTo];
        stamp++;
        (int X, int Y, int Z) first = Cell(all.Low);
        (int X, int Y, int Z) last = Cell(all.High);
        for (int x = first.X; x <= last.X; x++)
        {
            for (int y = first.Y; y <= last.Y; y++)
            {
                for (int z = first.Z; z <= last.Z; z++)
                {
                    for (int e = heads[Slot(x, y, z)]; e >= 0; e = chain[e].Following)
                    {
                        int u = chain[e].Triangle;
                        ref Box box = ref boxes[u];
                        if (box.Stamp == stamp)
                        {
                            continue;
                        }

                        box.Stamp = stamp;
                        if (box.Meets(all) && !surface.IsGone(u))
                        {
                            int i = points[3 * u], j = points[(3 * u) + 1], k = points[(3 * u) + 2];
                            if (i != pulledTo && j != pulledTo && k != pulledTo && pieceOf[i] == piece)
                            {
                                nearby.Add(u);
                            }
                        }
                    }
                }
            }
        }
    }

    private bool CrossesNearby(int t)
    {
        int a = points[3 * t], b = points[(3 * t) + 1], c = points[(3 * t) + 2];
        Box own = BoxOf(t);
        var side = new PlaneSide(positions[a], positions[b], positions[c], tolerance);
        foreach (int u in nearby)
        {
            if (!boxes[u].Meets(own))
            {
                continue;
            }

            int i = points[3 * u], j = points[(3 * u) + 1], k = points[(3 * u) + 2];
            if (!Connected(a, b, c, i, j, k) && !side.IsOneOf(positions[i], positions[j], positions[k]) && TriangleCrossing.Cross(positions[a], positions[b], positions[c], positions[i], positions[j], positions[k], tolerance))
            {
                return true;
            }
        }

        return false;
    }

    private static bool Connected(int a, int b, int c, int i, int j, int k) => i == a || i == b || i == c || j == a || j == b || j == c || k == a || k == b || k == c;

    private void Enter(int t)
    {
        (int X, int Y, int Z) first = Cell(boxes[t].Low);
        (int X, int Y, int Z) last = Cell(boxes[t].High);
        for (int x = first.X; x <= last.X; x++)
        {
            for (int y = first.Y; y <= last.Y; y++)
            {
                for (int z = first.Z; z <= last.Z; z++)
                {
                    if (entries == chain.Length)
                    {
                        Array.Resize(ref chain, 2 * entries);
                    }

                    ref int head = ref heads[Slot(x, y, z)];
                    chain[entries] = new Entry { Triangle = t, Following = head };
                    head = entries++;
                }
            }
        }
    }

    private Box BoxOf(int t)
    {
        Vector3 a = positions[points[3 * t]], b = positions[points[(3 * t) + 1]], c = positions[points[(3 * t) + 2]];
        return new Box { Low = Vec.Min(a, Vec.Min(b, c)), High = Vec.Max(a, Vec.Max(b, c)) };
    }

    private (int X, int Y, int Z) Cell(Vector3 p) => ((int)((p.X - origin.X) * perCell), (int)((p.Y - origin.Y) * perCell), (int)((p.Z - origin.Z) * perCell));

    private int Slot(int x, int y, int z) => unchecked((x * 73856093) ^ (y * 19349663) ^ (z * 83492791)) & (heads.Length - 1);

    /// <summary>A triangle in a cell of the grid, and the next one there.</summary>
    private struct Entry
    {
        public int Triangle;
        public int Following;
    }

    /// <summary>The box of a triangle, and by which search it was seen last: side by side, as they are asked for together.</summary>
    private struct Box
    {
        public Vector3 Low;
        public int Stamp;
        public Vector3 High;

        public readonly bool Meets(in Box other) =>
            Low.X <= other.High.X & High.X >= other.Low.X & Low.Y <= other.High.Y & High.Y >= other.Low.Y & Low.Z <= other.High.Z & High.Z >= other.Low.Z;
    }

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
