using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>
/// Hair as overlapping locks: flat narrow strands that taper to a point, in staggered rows, each of which begins below the skin and follows it at a growing distance.
/// </summary>
/// <remarks>
/// A lock is laid along the body's grid, not along a straight line: whatever the shape of neck and shoulder, it neither floats nor sinks, and each of its sections moves with the skin below it.
/// </remarks>
internal static class ManeShape
{
    private const int Sides = 4;

    /// <summary>The last ring that hair is laid along.</summary>
    private const int LastRing = BodyGrid.Rings - 2;

    /// <summary>How far tips curl back to the skin, as a share of their rise.</summary>
    private const float Curl = 0.55f;

    /// <summary>Half thickness of a lock relative to its half width.</summary>
    private const float Thickness = 0.24f;

    /// <summary>How much the edges of a lock face the way the skin below does: hair is shaded as one soft mass.</summary>
    private const float Softness = 0.75f;

    /// <summary>Shade of the edges of a lock and of its middle: it reads as a strand of many hairs, not as a leaf.</summary>
    private const float EdgeShade = 0.74f, MiddleShade = 1.08f;

    /// <summary>How much longer or shorter than the mane a single lock may be.</summary>
    private const double LengthVariety = 0.2;

    // From root to tip: where a section lies, and how wide it is. Strands taper from the first third on. The finest first; fewer sections are for hair that would not leave the rest its triangles.
    private static readonly Vector2[][] sectionsOf =
    {
        new Vector2[] { new(0f, 0.70f), new(0.25f, 1f), new(0.55f, 0.78f), new(0.82f, 0.36f) },
        new Vector2[] { new(0f, 0.74f), new(0.32f, 1f), new(0.70f, 0.56f) },
        new Vector2[] { new(0f, 0.80f), new(0.45f, 0.92f) },
    };

    /// <summary>How coarse the locks of some manes have to be that they have no more triangles than there is room for: 0 the finest, as coarse as there are where there is no room for any.</summary>
    public static int CoarsenessWithin(int triangles, IReadOnlyList<ManeBlueprint> manes)
    {
        int locks = 0;
        foreach (ManeBlueprint mane in manes)
        {
            foreach (LockRoot root in RootsOf(mane))
            {
                locks += root.Median ? 1 : 2;
            }
        }

        int coarseness = 0;
        while (coarseness < sectionsOf.Length - 1 && locks * TrianglesOf(sectionsOf[coarseness].Length) > triangles)
        {
            coarseness++;
        }

        return coarseness;
    }

    /// <summary>Appends all locks of a mane, left, right and on the midline.</summary>
    /// <param name="builder">Where they go.</param>
    /// <param name="mane">Where it grows and how.</param>
    /// <param name="coarseness">How coarse its locks are, 0 the finest; <see cref="CoarsenessWithin"/>.</param>
    /// <param name="skin">The body.</param>
    /// <param name="colour">Linear RGB of the middle of a lock.</param>
    /// <param name="addresses">Gets the place on the body that each vertex follows.</param>
    public static void Append(PieceBuilder builder, ManeBlueprint mane, int coarseness, BodySkin skin, Vector3 colour, List<SkinAddress> addresses)
    {
        foreach (LockRoot root in RootsOf(mane))
        {
            AppendLock(builder, mane, sectionsOf[coarseness], skin, root, colour * root.Shade, addresses);
        }
    }

    /// <summary>Triangles of a lock: its root is closed by two, its tip by one for each side.</summary>
    private static int TrianglesOf(int sections) => (2 * Sides * (sections - 1)) + Sides + (Sides - 2);

    private static List<LockRoot> RootsOf(ManeBlueprint mane)
    {
        var roots = new List<LockRoot>(mane.Rows * mane.Columns);
        int lockCount = 0;
        for (int row = 0; row < mane.Rows; row++)
        {
            double along = mane.Rows > 1 ? row / (mane.Rows - 1.0) : 0;
            double stagger = (row & 1) == 0 ? 0 : 0.5;
            double step = mane.Columns > 1 ? (mane.LastSegment - mane.Segment) / (mane.Columns - 1.0) : 0;
            double rowStep = mane.Rows > 1 ? (mane.LastRing - mane.Ring) / (mane.Rows - 1.0) : 0;
            for (int column = 0; column < mane.Columns; column++)
            {
                double segment = mane.Segment + ((column + stagger) * step);
                if (segment > mane.LastSegment + 1e-9)
                {
                    continue;
                }

                lockCount++;
                bool median = segment is 0 or BodyGrid.Segments / 2;
                if (!median)
                {
                    segment = Scalar.Clamp(segment + (0.3 * step * Jitter(lockCount, 4)), mane.Segment, mane.LastSegment);
                }

                roots.Add(new LockRoot(mane.Ring + (along * (mane.LastRing - mane.Ring)) + (0.3 * rowStep * Jitter(lockCount, 3)), segment, median)
                {
                    Length = mane.Length * Scalar.Lerp(1, mane.Growth, along) * (1 + (LengthVariety * Jitter(lockCount, 0))),
                    Turn = median ? 0 : 0.2 * Jitter(lockCount, 1),
                    Bend = median ? 0 : 0.5 * Jitter(lockCount, 5),
                    Shade = (float)(1 + (0.16 * Jitter(lockCount, 2))),
                });
            }
        }

        return roots;
    }

    private static void AppendLock(PieceBuilder builder, ManeBlueprint mane, ReadOnlySpan<Vector2> sections, BodySkin skin, in LockRoot root, Vector3 colour, List<SkinAddress> addresses)
    {
        int vertex = builder.VertexCount;
        int index = builder.IndexCount;
        int address = addresses.Count;
        var path = new LockPath(mane, skin, root);
        float width = (float)mane.Width;
        Span<TubeRow> rows = stackalloc TubeRow[sections.Length];
        for (int i = 0; i < rows.Length; i++)
        {
            float s = sections[i].X;
            float half = width * sections[i].Y;
            float shade = Scalar.Lerp(0.72f, 1f, Scalar.Smooth(s * 1.6f));
            rows[i] = new TubeRow(path.At(s, out SkinAddress place), half, Thickness * half, colour * shade);
            for (int k = 0; k < Sides; k++)
            {
                addresses.Add(place);
            }
        }

        Vector3 tip = path.At(1f, out SkinAddress end);
        addresses.Add(end);
        SweptTube.Append(builder, rows, tip, colour * MiddleShade, path.Across, Sides);
        Streak(builder, vertex, rows);
        Soften(builder, vertex, rows.Length * Sides, path.Normal);
        if (!root.Median)
        {
            builder.AppendMirrored(vertex, index);
            for (int k = address, last = addresses.Count; k < last; k++)
            {
                addresses.Add(addresses[k].Mirrored);
            }
        }
    }

    // The first axis of a section runs across the lock: its vertices 0 and 2 are the edges, 1 and 3 the middle.
    private static void Streak(PieceBuilder builder, int first, ReadOnlySpan<TubeRow> rows)
    {
        for (int i = 0; i < rows.Length; i++)
        {
            for (int k = 0; k < Sides; k++)
            {
                builder.SetColour(first + (i * Sides) + k, rows[i].Colour * ((k & 1) == 0 ? EdgeShade : MiddleShade));
            }
        }
    }

    private static void Soften(PieceBuilder builder, int first, int count, Vector3 skin)
    {
        for (int v = first; v < first + count; v++)
        {
            Vector3 own = builder.Normal(v);
            if (Vec.Dot(own, skin) > -0.5f)
            {
                builder.SetNormal(v, Vec.Normalize(Vec.Lerp(own, skin, Softness), own));
            }
        }
    }

    /// <summary>The same number in −1..1 for the same lock, unlike that of its neighbours (multiples of irrational numbers are evenly spread).</summary>
    private static double Jitter(int lockNumber, int trait)
    {
        double x = (lockNumber * 0.6180339887498949) + (trait * 0.4142135623730951 * lockNumber) + (trait * 0.37);
        return (2 * (x - Math.Floor(x))) - 1;
    }

    /// <summary>Where a lock grows and what sets it apart from the others.</summary>
    private readonly struct LockRoot
    {
        public LockRoot(double ring, double segment, bool median)
        {
            Ring = ring;
            Segment = segment;
            Median = median;
            Length = 0;
            Turn = 0;
            Bend = 0;
            Shade = 1f;
        }

        public double Ring { get; }

        public double Segment { get; }

        public bool Median { get; }

        /// <summary>Metres.</summary>
        public double Length { get; init; }

        /// <summary>Added to the direction in which hair falls, radians.</summary>
        public double Turn { get; init; }

        /// <summary>How far that direction turns on between root and tip, radians.</summary>
        public double Bend { get; init; }

        /// <summary>How much lighter or darker than the mane it is, a factor.</summary>
        public float Shade { get; init; }
    }

    /// <summary>The middle line of a lock.</summary>
    private readonly struct LockPath
    {
        private const float Drop = 0.8f;

        /// <summary>Upward part of the skin's normal where hair that lies on it ends: farther round it would cling to the body's underside, and from ahead be a frame around the face.</summary>
        private const float Undercut = -0.1f;

        /// <summary>Least share of the way to there that hair lies on as it is; what is longer ends closer and closer to there, so that its tips are not in one line.</summary>
        private const double Unbent = 0.6;

        private readonly BodySkin skin;
        private readonly LockRoot root;
        private readonly double rootArc;
        private readonly double along;
        private readonly double segmentsAround;
        private readonly double alongBend;
        private readonly double segmentsBend;
        private readonly float rise;
        private readonly float hang;
        private readonly float sunk;

        public LockPath(ManeBlueprint mane, BodySkin skin, in LockRoot root)
        {
            this.skin = skin;
            this.root = root;
            double reach = root.Length * PortableMath.Cos(mane.Rise);
            bool forward = mane.Fall > PortableMath.Pi / 2;
            double fall = root.Median ? (forward ? PortableMath.Pi : 0) : mane.Fall + root.Turn;
            Vector3 here = skin.At(root.Ring, root.Segment).Position;
            float perSegment = Vec.Distance(skin.At(root.Ring, root.Segment + 1).Position, here);
            rootArc = BodyShape.At(skin.Shape.Arc, root.Ring);
            along = reach * PortableMath.Cos(fall);
            segmentsAround = reach * PortableMath.Sin(fall) / Math.Max(perSegment, 1e-3f);
            alongBend = -0.5 * root.Bend * reach * PortableMath.Sin(fall);
            segmentsBend = 0.5 * root.Bend * reach * PortableMath.Cos(fall) / Math.Max(perSegment, 1e-3f);
            if (mane.Hang == 0 && segmentsAround + segmentsBend > 0)
            {
                double shorter = Lying(segmentsAround + segmentsBend, Underside(skin, root) - root.Segment) / (segmentsAround + segmentsBend);
                segmentsAround *= shorter;
                segmentsBend *= shorter;
            }

            rise = (float)(root.Length * PortableMath.Sin(mane.Rise));
            hang = (float)(root.Length * mane.Hang);

            // Under the body hair hangs down instead of lying back.
            along *= 1 - (Drop * Math.Max(0f, -skin.At(root.Ring, root.Segment).Normal.Y) * Math.Min(1, 2 * mane.Hang));
            sunk = 0.30f * (float)mane.Width;
            SurfacePoint at = skin.At(root.Ring, root.Segment);
            Normal = root.Median ? Vec.Normalize(new Vector3(0f, at.Normal.Y, at.Normal.Z), Vector3.UnitY) : at.Normal;
            Vector3 tailward = skin.At(root.Ring + 0.5, root.Segment).Position - here;
            Vector3 side = Vec.Normalize(Vec.Cross(at.Normal, tailward), Vector3.UnitX);
            Vector3 back = Vec.Normalize(Vec.Reject(tailward, at.Normal), Vector3.UnitZ);
            Across = root.Median ? Vector3.UnitX : Vec.Normalize((side * (float)PortableMath.Cos(fall)) + (back * (float)PortableMath.Sin(fall)), Vector3.UnitX);
        }

        /// <summary>Unit outward direction of the skin at its root.</summary>
        public Vector3 Normal { get; }

        /// <summary>Unit direction across the flat lock at its root.</summary>
        public Vector3 Across { get; }

        /// <summary>A point of the line, 0 at the root and 1 at the tip, and the place of the skin that it moves with.</summary>
        public Vector3 At(float s, out SkinAddress place)
        {
            double arc = rootArc + (s * along) + (s * s * alongBend);
            double last = skin.Shape.Arc[LastRing];
            double ring = skin.Shape.RingAt(Scalar.Clamp(arc, 0, last));
            double segment = root.Median ? root.Segment : Scalar.Clamp(root.Segment + (s * segmentsAround) + (s * s * segmentsBend), 0.02, (BodyGrid.Segments / 2) - 0.02);
            place = new SkinAddress((int)Math.Round(ring), (int)Math.Round(segment));
            SurfacePoint at = skin.At(ring, segment);
            float lift = (rise * s * (1f - (Curl * s))) - (sunk * (1f - s) * (1f - s));
            float below = Math.Max(0f, -at.Normal.Y);
            Vector3 p = at.Position + (at.Normal * lift) - (Vector3.UnitY * (hang * below * s * s));
            if (arc > last)
            {
                // Hair of a tail hangs on where the tail ends, drawn together.
                p = Vec.Lerp(p, skin.Shape.Centre(LastRing), 0.35f * s) - (skin.Shape.Forward(LastRing) * (float)(arc - last));
            }

            return root.Median ? new Vector3(0f, p.Y, p.Z) : p;
        }

        /// <summary>The segment at which the body begins to turn under, at the root of a lock.</summary>
        private static double Underside(BodySkin skin, in LockRoot root)
        {
            int segment = (int)Math.Ceiling(root.Segment);
            while (segment < BodyGrid.Segments / 2 && skin.At(root.Ring, segment).Normal.Y > Undercut)
            {
                segment++;
            }

            return segment;
        }

        /// <summary>How far a lock goes round that is as long as <paramref name="segments"/>, where there are as many as <paramref name="room"/>.</summary>
        private static double Lying(double segments, double room)
        {
            double free = Unbent * room;
            double rest = room - free;
            return segments <= free ? segments : rest <= 0 ? Math.Max(free, 0) : free + (rest * (1 - PortableMath.Exp((free - segments) / rest)));
        }
    }
}
