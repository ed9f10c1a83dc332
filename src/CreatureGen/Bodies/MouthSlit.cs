using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>
/// Cuts the head along a line from one lip corner around the nose to the other, opens it as lips and lines it with a dark bag, so that the surface stays closed.
/// </summary>
internal sealed class MouthSlit
{
    /// <summary>Segment of the slit on the left flank.</summary>
    public const int LeftSegment = BodyGrid.LipSegment;

    private const int RightSegment = BodyGrid.Segments - LeftSegment;
    private const int CapCells = 8;
    private const int CapRow = LeftSegment - 4;
    private const int BagRows = 4;

    /// <summary>Radians. Lips touch without crossing.</summary>
    private const double LipGap = 0.012;

    /// <summary>Half height of the closed mouth's inside relative to the thickness of the head.</summary>
    private const float Cavity = 0.5f;

    private readonly int corner;
    private readonly int[] upper;
    private readonly int[] lower;

    private MouthSlit(int corner, int[] upper, int[] lower)
    {
        this.corner = corner;
        this.upper = upper;
        this.lower = lower;
    }

    /// <summary>Vertices of the upper lip from the left corner to the right; empty without a mouth.</summary>
    public IReadOnlyList<int> UpperLip => upper;

    /// <summary>Vertices of the lower lip from the left corner to the right; empty without a mouth.</summary>
    public IReadOnlyList<int> LowerLip => lower;

    /// <summary>How far the nose bulges ahead of the first ring, metres.</summary>
    public static float NoseBulge(BodyShape shape) => (float)shape.Width[StationRing.Nose] * 0.75f;

    /// <summary>The angle by which the lower jaw is turned down at rest, radians.</summary>
    public static double AngleOf(MouthBlueprint mouth) => mouth.Opening + LipGap;

    /// <summary>Adds the faces of the body, the caps of nose and tail, and the mouth.</summary>
    public static MouthSlit CloseBody(BodySurface body, HeadBlueprint head, TailStyle tailStyle)
    {
        SurfaceBuilder surface = body.Surface;
        BodyShape shape = body.Skin.Shape;
        int corner = head.Mouth.CornerRing;
        int[] cap = CapGrid.Vertices(surface, body.NoseLoop(), CapCells, CapCells, shape.Forward(StationRing.Nose), NoseBulge(shape), Address(SurfaceRegion.Nose, 0f, 0));
        PairCap(surface, cap, CapCells, CapCells);
        MouthSlit mouth = corner == 0 ? new MouthSlit(0, Array.Empty<int>(), Array.Empty<int>()) : Split(surface, body, cap, corner);
        body.AddFaces(mouth);
        mouth.FillNose(surface, cap, (float)shape.Width[StationRing.Nose] * 2f);

        CloseTail(body, tailStyle);
        if (corner > 0)
        {
            mouth.OpenJaw(surface, body, cap, head.Mouth);
            mouth.AddBag(surface, shape);
        }

        return mouth;
    }

    /// <summary>The vertex of a ring and segment as the given cell of the body sees it: below the slit, the lower lip's copy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Vertex(BodySurface body, int ring, int segment, int cellRing, int cellSegment)
    {
        segment &= BodyGrid.Segments - 1;
        if (cellRing >= corner || cellSegment < LeftSegment || cellSegment >= RightSegment || ring >= corner || (segment != LeftSegment && segment != RightSegment))
        {
            return body[ring, segment];
        }

        return segment == LeftSegment ? lower[corner - ring] : lower[lower.Length - 1 - (corner - ring)];
    }

    private static VertexAddress Address(SurfaceRegion region, float along, int ring) =>
        new() { Region = region, Appendage = -1, Sign = 1, Along = along, Ring = ring };

    /// <summary>Closes the tip of the tail: round ends with a square grid, flat ones with a narrow grid along their edge.</summary>
    private static void CloseTail(BodySurface body, TailStyle style)
    {
        SurfaceBuilder surface = body.Surface;
        BodyShape shape = body.Skin.Shape;
        int last = BodyGrid.Rings - 1;
        bool round = style == TailStyle.Plain || TailTaper.Of(style) != null;
        int rows = style switch { _ when round => CapCells, TailStyle.Feathers or TailStyle.Fluke => 2, _ => (2 * CapCells) - 2 };
        int columns = (2 * CapCells) - rows;
        float bulge = round ? (float)Math.Min(shape.Width[last], Math.Min(shape.Top[last], shape.Bottom[last])) * 0.9f : 0f;
        int[] tail = CapGrid.Vertices(surface, body.TailLoop(), rows, columns, -shape.Forward(last), bulge, Address(SurfaceRegion.Body, 1f, last));
        if (!round)
        {
            CapGrid.Rule(surface, tail, rows, columns);
        }

        PairCap(surface, tail, rows, columns);
        FillMirrored(surface, tail, rows, columns, surface.NewChart(), (float)shape.Width[last] * 2f, (v, _) => v);
    }

    /// <summary>Tells the inner vertices of a cap their side, mirror image, and place around the body.</summary>
    private static void PairCap(SurfaceBuilder surface, int[] cap, int rows, int columns)
    {
        int stride = columns + 1;
        bool leftFirst = surface.Positions[cap[stride * (rows / 2)]].X > 0;
        for (int r = 1; r < rows; r++)
        {
            for (int c = 1; c < columns; c++)
            {
                int v = cap[(r * stride) + c];
                int m = cap[(r * stride) + (columns - c)];
                surface.Mirror[v] = m;
                Vector3 p = surface.Positions[v];
                surface.Positions[v] = 2 * c == columns ? new Vector3(0f, p.Y, p.Z) : 2 * c > columns ? Vec.Mirror(surface.Positions[m]) : p;
                VertexAddress address = surface.Addresses[v];
                double around = PortableMath.Atan2(Math.Abs((2.0 * c / columns) - 1), 1 - (2.0 * r / rows));
                address.Sign = (sbyte)(2 * c == columns || leftFirst == (2 * c < columns) ? 1 : -1);
                address.Around = (float)around;
                address.Segment = (float)((address.Sign > 0 ? around : PortableMath.Tau - around) * BodyGrid.Segments / PortableMath.Tau);
                surface.Addresses[v] = address;
            }
        }
    }

    private static MouthSlit Split(SurfaceBuilder surface, BodySurface body, int[] cap, int corner)
    {
        var chain = new List<int>();
        for (int i = corner; i >= 0; i--)
        {
            chain.Add(body[i, LeftSegment]);
        }

        for (int c = 1; c < CapCells; c++)
        {
            chain.Add(cap[(CapRow * (CapCells + 1)) + c]);
        }

        for (int i = 0; i <= corner; i++)
        {
            chain.Add(body[i, RightSegment]);
        }

        int[] upper = chain.ToArray();
        int[] lower = (int[])upper.Clone();
        int last = upper.Length - 1;
        for (int k = 1; k < last; k++)
        {
            VertexAddress address = surface.Addresses[upper[k]];
            address.Region = SurfaceRegion.Lip;
            surface.Addresses[upper[k]] = address;
            lower[k] = surface.Add(surface.Positions[upper[k]], address);
        }

        PairRow(surface, lower, 1, last - 1);
        return new MouthSlit(corner, upper, lower);
    }

    private static void PairRow(SurfaceBuilder surface, int[] row, int first, int last)
    {
        for (int k = first; k <= last; k++)
        {
            surface.Mirror[row[k]] = row[first + last - k];
        }
    }

    private void FillNose(SurfaceBuilder surface, int[] cap, float size)
    {
        const int Stride = CapCells + 1;
        FillMirrored(surface, cap, CapCells, CapCells, surface.NewChart(), size, (v, row) =>
        {
            if (row < CapRow || corner == 0)
            {
                return v;
            }

            for (int c = 0; c <= CapCells; c++)
            {
                if (cap[(CapRow * Stride) + c] == v)
                {
                    return lower[corner + c];
                }
            }

            return v;
        });
    }

    /// <summary>Fills a cap so that its left and right halves split along mirrored diagonals. <paramref name="replace"/> gets vertex and row of the cell.</summary>
    private static void FillMirrored(SurfaceBuilder surface, int[] cap, int rows, int columns, int chart, float size, Func<int, int, int> replace)
    {
        int stride = columns + 1;
        for (int r = 0; r < rows; r++)
        {
            for (int c = 0; c < columns; c++)
            {
                int a = replace(cap[(r * stride) + c], r);
                int b = replace(cap[(r * stride) + c + 1], r);
                int d = replace(cap[((r + 1) * stride) + c + 1], r);
                int e = replace(cap[((r + 1) * stride) + c], r);
                FaceTexcoords t = CapGrid.CellTexcoords(r, c, rows, columns, new Vector2(size, size));
                if (2 * c < columns)
                {
                    surface.Quad(a, b, d, e, chart, t);
                }
                else
                {
                    surface.Quad(b, d, e, a, chart, new FaceTexcoords(t.B, t.C, t.D, t.A));
                }
            }
        }
    }

    /// <summary>Turns the lower jaw about its hinge and lifts or drops the lip corners.</summary>
    private void OpenJaw(SurfaceBuilder surface, BodySurface body, int[] cap, MouthBlueprint blueprint)
    {
        BodyShape shape = body.Skin.Shape;
        int hingeRing = Math.Min(corner + 3, 14);
        Vector3 hinge = body.Skin[hingeRing, LeftSegment];
        hinge.X = 0f;
        double angle = AngleOf(blueprint);
        for (int i = 0; i <= hingeRing; i++)
        {
            double along = i <= corner ? 1 : Scalar.Smooth((hingeRing - i) / (hingeRing - corner + 1.0));
            for (int j = LeftSegment; j <= RightSegment; j++)
            {
                bool lip = j is LeftSegment or RightSegment;
                if (lip && i >= corner)
                {
                    continue;
                }

                int edge = Math.Min(j - LeftSegment, RightSegment - j);
                double weight = along * (i <= corner ? 1 : Scalar.Smooth(edge / 3.0));
                Turn(surface, lip ? Vertex(body, i, j, 0, LeftSegment) : body[i, j], hinge, angle * weight);
            }
        }

        for (int r = CapRow; r < CapCells; r++)
        {
            for (int c = 1; c < CapCells; c++)
            {
                Turn(surface, r == CapRow ? lower[corner + c] : cap[(r * (CapCells + 1)) + c], hinge, angle);
            }
        }

        float lift = (float)(blueprint.Smile * 0.16 * shape.Width[Math.Min(corner + 3, 13)]);
        for (int i = 0; i < corner + 3; i++)
        {
            double fraction = PortableMath.Pow(Math.Min(i, corner) / (double)corner, 2.2) * (i <= corner ? 1 : i == corner + 1 ? 0.5 : 0.2);
            for (int d = -2; d <= 2; d++)
            {
                float weight = (float)(fraction * (d == 0 ? 1 : Math.Abs(d) == 1 ? 0.7 : 0.3));
                Vector3 shift = shape.Up(i) * (lift * weight);
                Shift(body[i, LeftSegment + d]);
                Shift(body[i, RightSegment - d]);
                if (d == 0 && i < corner)
                {
                    Shift(Vertex(body, i, LeftSegment, 0, LeftSegment));
                    Shift(Vertex(body, i, RightSegment, 0, LeftSegment));
                }

                void Shift(int v) => surface.Positions[v] += shift;
            }
        }
    }

    private static void Turn(SurfaceBuilder surface, int vertex, Vector3 hinge, double angle) =>
        surface.Positions[vertex] = hinge + Vec.Rotate(surface.Positions[vertex] - hinge, Vector3.UnitX, angle);

    private void AddBag(SurfaceBuilder surface, BodyShape shape)
    {
        int last = upper.Length - 1;
        int chart = surface.NewChart();
        int[] previous = upper;
        for (int row = 1; row <= BagRows; row++)
        {
            int[] current = (int[])lower.Clone();
            if (row < BagRows)
            {
                float t = (float)row / BagRows;
                float pull = 0.5f * (float)PortableMath.Sin(PortableMath.Pi * t);
                for (int k = 1; k < last; k++)
                {
                    Vector3 p = Vec.Lerp(surface.Positions[upper[k]], surface.Positions[lower[k]], t);
                    int ring = Math.Min(corner, Math.Max(0, Math.Abs(k - (last / 2)) - 4));
                    int inner = Math.Max(ring, Math.Min(4, corner));
                    Vector3 axis = shape.Centre(inner) + (shape.Up(inner) * Vec.Dot(p - shape.Centre(ring), shape.Up(ring)));

                    // The bag opens inwards even behind closed lips, or its walls would touch.
                    float room = Cavity * (float)Math.Min(shape.Top[inner], shape.Bottom[inner]) * Scalar.Smooth(Math.Min(k, last - k) / 3f);
                    axis += shape.Up(inner) * (room * (1f - (2f * t)));
                    VertexAddress address = surface.Addresses[upper[k]];
                    address.Region = SurfaceRegion.Mouth;
                    address.Around += t * 0.05f;
                    current[k] = surface.Add(p + ((axis - p) * pull), address);
                }

                PairRow(surface, current, 1, last - 1);
            }

            for (int k = 0; k < last / 2; k++)
            {
                int m = last - k;
                FaceTexcoords t = CapGrid.CellTexcoords(row, k, BagRows + 1, last / 2, new Vector2(0.1f, 0.05f));
                AddBagFace(surface, chart, previous[k], current[k], current[k + 1], previous[k + 1], new FaceTexcoords(t.A, t.D, t.C, t.B));
                AddBagFace(surface, chart, previous[m], previous[m - 1], current[m - 1], current[m], t);
            }

            previous = current;
        }
    }

    /// <summary>Adds a face of the bag, facing into the mouth; at the lip corners it is a triangle.</summary>
    private static void AddBagFace(SurfaceBuilder surface, int chart, int a, int b, int c, int d, FaceTexcoords t)
    {
        // Reversed: seen from inside the mouth.
        if (a == b)
        {
            surface.Quad(d, c, a, a, chart, new FaceTexcoords(t.D, t.C, t.A, t.A));
        }
        else if (a == d)
        {
            surface.Quad(c, b, a, a, chart, new FaceTexcoords(t.C, t.B, t.A, t.A));
        }
        else
        {
            surface.Quad(d, c, b, a, chart, new FaceTexcoords(t.D, t.C, t.B, t.A));
        }
    }
}
