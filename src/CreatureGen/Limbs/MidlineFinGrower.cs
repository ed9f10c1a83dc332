using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Limbs;

/// <summary>Grows a fin out of the midline of back or belly by extruding a strip two cells wide.</summary>
internal static class MidlineFinGrower
{
    /// <summary>Share of the distance between two rows that the shear of their columns may take up: below 1 no row overtakes the next.</summary>
    private const float ShearLimit = 0.7f;

    /// <summary>Metres by which the fin stands off the skin before it leans back.</summary>
    private const float Lift = 0.012f;

    // Thickness in that of the base: where the fin leaves the skin, what of it is flesh above that and thins out evenly, and what is left at the edge. A thinner one is a sheet of paper from behind.
    private const float Foot = 1f;
    private const float FleshyPart = 0.92f;
    private const float Edge = 0.06f;

    // Half thickness of a fin above its foot in its height at least, and most that it bulges over the socket for it: a high fin on a narrow back is a needle from the front.
    private const float Stout = 0.1f;
    private const float MostStout = 1.5f;

    /// <summary>Thickness of the first and last row, and of the skin between two rays, in that of the rays between.</summary>
    private const double Ends = 0.4;
    private const float BetweenRays = 0.82f;

    /// <summary>Height of the edge between two rays of a sail, in that of the rays.</summary>
    private const float Scallop = 0.9f;

    // Where the tip of a shark's fin is over its base, in that of one that is high, by its height in lengths of the base; and how soon the rear edge of a low one is there.
    private const float Stem = 0.2f;
    private const float Rake = 1.15f;
    private const double RunsOut = 1.7;

    private static readonly float[] sections = { 0.06f, 0.16f, 0.32f, 0.5f, 0.68f, 0.84f, 0.94f, 1f };

    /// <summary>Grows the fin and says where its joints are.</summary>
    public static Appendage Grow(BodySurface body, FinBlueprint fin, int index)
    {
        SurfaceBuilder surface = body.Surface;
        BodyShape shape = body.Skin.Shape;
        SocketLoop socket = SocketLoop.Cut(body, fin.Socket);
        int rows = fin.Socket.Rows;
        int count = socket.Vertices.Length;
        float side = fin.Place == FinPlace.Ventral ? -1f : 1f;
        float height = (float)fin.Length;
        MidlineFin? form = MidlineFin.Of(fin.Style);

        var up = new Vector3[rows + 1];
        var ahead = new Vector3[rows + 1];
        var midline = new Vector3[rows + 1];
        float[] outline = new float[rows + 1];
        Vector3 meanUp = Vector3.Zero;
        Vector3 meanAhead = Vector3.Zero;
        for (int r = 0; r <= rows; r++)
        {
            meanUp += shape.Up(fin.Socket.Ring + r) * side;
            meanAhead += shape.Forward(fin.Socket.Ring + r);
            Vector3 p = socket.Points[r == 0 ? 0 : r + 1];
            midline[r] = new Vector3(0f, p.Y, p.Z);
            outline[r] = form is null ? Outline(fin.Style, r, (float)r / rows) : (float)form.HeightAt((double)r / rows);
        }

        meanUp = Vec.Normalize(meanUp);
        meanAhead = Vec.Normalize(meanAhead);
        for (int r = 0; r <= rows; r++)
        {
            // Columns that all lean the same way do not run into one another on a bent back.
            up[r] = Vec.Normalize((shape.Up(fin.Socket.Ring + r) * (side * 0.35f)) + (meanUp * 0.65f));
            ahead[r] = (shape.Forward(fin.Socket.Ring + r) * 0.35f) + (meanAhead * 0.65f);
        }

        float shear = Shear(fin, height, midline, outline);
        int chart = surface.NewChart();
        float length = Vec.Distance(midline[0], midline[rows]);
        float reach = Math.Min(1f, Stem + (Rake * height / length));
        float stout = Scalar.Clamp(Stout * height / Math.Max(Array.ConvertAll(socket.Points, p => p.X).Max(), 1e-3f), 1f, MostStout);
        int[] previous = socket.Vertices;
        float before = 0f;
        foreach (float s in sections)
        {
            float thickness = s < 0.1f ? Foot : (FleshyPart * (float)PortableMath.Pow(1 - s, 0.9)) + Edge;
            int[] current = new int[count];
            for (int k = 0; k < count; k++)
            {
                int r = RowOf(k, rows);
                float u = (float)r / rows;
                Vector3 p;
                if (fin.Style == FinStyle.Shark || form?.Overhang != null)
                {
                    // Chord lines instead of columns: the tip overhangs without folding.
                    (float a, float b) = form?.Overhang is (double Front, double Rear) over ? Veil(over, s) : Shark(s, reach);
                    float ray = form is null ? 1f : outline[r];
                    p = OnMidline(midline, a + ((b - a) * u)) + (meanUp * ((height * ray * s) + (Lift * Scalar.Smooth(s / 0.12f))));
                }
                else
                {
                    float h = height * outline[r] * s;
                    p = midline[r] + (up[r] * (h + (Lift * Scalar.Smooth(s / 0.12f)))) - (ahead[r] * (h * shear));
                }

                p.X = socket.Points[k].X * thickness * Scalar.Lerp(1f, stout, Scalar.Smooth(s / 0.2f)) * Section(r, u, s);
                VertexAddress address = surface.Addresses[socket.Vertices[k]];
                address.Region = SurfaceRegion.Fin;
                address.Appendage = (short)index;
                address.Along = s;
                address.Around = (float)(PortableMath.Pi * u);
                current[k] = surface.Add(p, address);
            }

            for (int k = 0; k < count; k++)
            {
                surface.Mirror[current[k]] = current[(count - k) % count];
            }

            AddStrip(surface, previous, current, chart, length * 2f, before * height, s * height);
            previous = current;
            before = s;
        }

        CapRidge(surface, previous, rows, meanUp, new VertexAddress { Region = SurfaceRegion.Fin, Appendage = (short)index, Sign = 1, Along = 1f });
        int centre = rows / 2;
        Vector3 tip = (surface.Positions[previous[centre + 1]] + surface.Positions[previous[(count - centre - 1) % count]]) / 2f;
        tip.X = 0f;
        return new Appendage
        {
            Kind = fin.Place == FinPlace.Ventral ? LimbKind.Ventral : LimbKind.Dorsal,
            Paired = false,
            RootRing = socket.CentreRing,
            Joints = new[] { midline[centre], Vec.Lerp(midline[centre], tip, 0.5f), tip },
            JointsAlong = new[] { 0f, 0.5f, 1f },
            Pole = -meanAhead,
            Contact = tip,
        };
    }

    /// <summary>The row of a socket's border vertex when the socket is two cells wide.</summary>
    private static int RowOf(int k, int rows)
    {
        if (k <= rows + 1)
        {
            return Math.Max(0, k - 1);
        }

        return k <= rows + 2 ? rows : Math.Max(0, (2 * rows) + 3 - k);
    }

    /// <summary>Where the chord of a shark's fin begins and ends over the base: its front bends over to the rear at the tip, which would be cut off level.</summary>
    /// <param name="s">Share of the height.</param>
    /// <param name="reach">How far back the tip is, in that of a fin as high as its base is long: behind a low one the rear edge runs out over the base.</param>
    private static (float Front, float Rear) Shark(float s, float reach) => (
        reach * ((0.90f * (float)PortableMath.Pow(s, 0.85)) + (0.12f * (float)PortableMath.Pow(s, 6))),
        1f + (0.08f * s * s) - (0.12f * (float)PortableMath.Sin(PortableMath.Pi * s)) - (0.05f * (float)PortableMath.Pow(s, 6)) - ((1f - reach) * 1.02f * (1f - (float)PortableMath.Pow(1f - s, RunsOut))));

    /// <summary>The same of a fin that hangs over the rear of its base.</summary>
    private static (float Front, float Rear) Veil((double Front, double Rear) over, float s) => (
        (float)(over.Front * PortableMath.Pow(s, 1.4)),
        1f + (float)(over.Rear * PortableMath.Sin(0.62 * PortableMath.Pi * s)));

    private static float Outline(FinStyle style, int row, float u) => style switch
    {
        FinStyle.Shark => Math.Max(0.02f, (float)(PortableMath.Pow(Scalar.Clamp(u / 0.45, 0, 1), 0.9) * PortableMath.Pow(Scalar.Clamp((1.0 - u) / 0.3, 0, 1), 0.6))),
        FinStyle.Spiny => Arch(u) * (row % 2 == 1 ? 1f : 0.68f),
        _ => Arch(u) * (row % 2 == 1 ? 1f : Scallop),
    };

    /// <summary>How thick a fin is at a row in relation to its thickest, a lens along its base that has no upright face ahead and behind, with rays that stand out of it above its foot.</summary>
    private static float Section(int row, float u, float s)
    {
        double lens = Scalar.Lerp(Ends, 1, Math.Sqrt(Math.Max(0, PortableMath.Sin(PortableMath.Pi * u))));
        double ray = row % 2 == 1 ? 1 : BetweenRays;
        return (float)Scalar.Lerp(1, lens * ray, Scalar.Smooth(s / 0.3));
    }

    /// <summary>The height of a sail over its base: highest ahead of its middle, and run out at both ends, where it would be cut off upright.</summary>
    private static float Arch(float u) => Math.Max(0.03f, (float)PortableMath.Sin(PortableMath.Pi * PortableMath.Pow(u, 0.85)));

    private static float Shear(FinBlueprint fin, float height, Vector3[] midline, float[] outline)
    {
        float shear = (float)fin.Sweep;
        for (int r = 1; r < midline.Length; r++)
        {
            float drop = height * (outline[r - 1] - outline[r]);
            if (drop > 1e-6f)
            {
                shear = Math.Min(shear, ShearLimit * Vec.Distance(midline[r], midline[r - 1]) / drop);
            }
        }

        return shear;
    }

    /// <summary>The midline at a share of its rows, drawn on straight beyond its end.</summary>
    private static Vector3 OnMidline(Vector3[] midline, float fraction)
    {
        int rows = midline.Length - 1;
        float y = fraction * rows;
        int i = Math.Min((int)Math.Max(y, 0f), rows - 1);
        return midline[i] + ((midline[i + 1] - midline[i]) * (y - i));
    }

    /// <summary>Adds a ring of quads whose left and right halves split along mirrored diagonals.</summary>
    private static void AddStrip(SurfaceBuilder surface, int[] previous, int[] current, int chart, float girth, float v0, float v1)
    {
        int count = previous.Length;
        for (int k = 0; k < count / 2; k++)
        {
            int m0 = (count - k) % count;
            int m1 = count - k - 1;
            float u0 = girth * k / count;
            float u1 = girth * (k + 1) / count;
            surface.Quad(previous[k], previous[k + 1], current[k + 1], current[k], chart, new FaceTexcoords(new Vector2(u0, v0), new Vector2(u1, v0), new Vector2(u1, v1), new Vector2(u0, v1)));
            surface.Quad(previous[m0], current[m0], current[m1], previous[m1], chart, new FaceTexcoords(new Vector2(u0, v0), new Vector2(u0, v1), new Vector2(u1, v1), new Vector2(u1, v0)));
        }
    }

    private static void CapRidge(SurfaceBuilder surface, int[] loop, int rows, Vector3 outward, VertexAddress address)
    {
        int[] grid = CapGrid.Vertices(surface, loop, rows, 2, outward, 0f, address);
        int chart = surface.NewChart();
        for (int r = 1; r < rows; r++)
        {
            int v = grid[(3 * r) + 1];
            Vector3 p = surface.Positions[v];
            surface.Positions[v] = new Vector3(0f, p.Y, p.Z);

            // The rows of the cap grew from the rings beside them.
            VertexAddress inner = surface.Addresses[v];
            VertexAddress border = surface.Addresses[grid[3 * r]];
            inner.Ring = border.Ring;
            inner.Segment = border.Segment;
            surface.Addresses[v] = inner;
        }

        for (int r = 0; r < rows; r++)
        {
            FaceTexcoords t = CapGrid.CellTexcoords(r, 0, rows, 2, new Vector2(0.02f, 0.05f * rows));
            int a = 3 * r;
            surface.Quad(grid[a], grid[a + 1], grid[a + 4], grid[a + 3], chart, t);
            surface.Quad(grid[a + 2], grid[a + 5], grid[a + 4], grid[a + 1], chart, new FaceTexcoords(t.A, t.D, t.C, t.B));
        }
    }
}
