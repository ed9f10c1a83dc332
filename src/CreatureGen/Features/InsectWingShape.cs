using System.Numerics;
using System;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A thin wing of an insect: a closed leaf of two layers that share their edge, veined in the colours of its vertices.</summary>
/// <remarks>
/// The outline is that of the wing's style; without one it follows from how broad the wing is: most are narrow at the hinge, broadest beyond the middle and round at the tip (wasp),
/// broad ones fan out. Broad wings have a dark margin. Material <see cref="MaterialKind.Membrane"/>.
/// </remarks>
internal static class InsectWingShape
{
    private const int Lines = 9;
    private const int Strips = Lines - 1;

    /// <summary>Stations from one dark band across the wing to the next; and how dark these are on broad wings and on slender ones, where they are cross veins, each strip's between those of its neighbours: plain, slender wings are planks.</summary>
    private const int Band = 4;
    private const float BandOfBroad = 0.22f;
    private const float CrossVein = 0.3f;

    // Half length of the pale patch of a broad wing, the line across the wing where it is palest, and from there to where it ends: cut off where its strip ends it is a pane.
    private const float PatchLength = 0.3f;
    private const float PatchLine = 0.63f;
    private const float PatchWidth = 0.28f;

    /// <summary>By how much the base of a wing without a style is broader than its outline has it, in widths.</summary>
    private const float Base = 0.16f;

    // The outline of one that is not broad, in widths behind the axis and lengths: where its rear edge is at the hinge and where it is broadest, how far its leading edge bows to the front there, and from where on it runs round into the tip.
    private const float Hinge = 0.1f;
    private const float Broadest = 0.98f;
    private const float Bow = 0.14f;
    private const float BroadestAt = 0.7f;
    private const float RoundFrom = 0.6f;

    /// <summary>Height of the middle of the blade over its edges, in widths of the blade there: a tip that bulges by as much as the middle is a spoon.</summary>
    private const float Camber = 0.06f;

    // Metres at the size of a creature with a torso of one metre.
    private const float RootDepth = 0.012f;

    // Wings keep off the midline by so much for each 1 that they rise; over so much of their length, and less by the root, which stays where it is, it is gone over to that.
    private const float OffMidline = 0.1f;
    private const float Softness = 0.09f;

    /// <summary>Appends a wing of the left side.</summary>
    /// <param name="builder">Where the wing goes.</param>
    /// <param name="skin">The body's surface at its root.</param>
    /// <param name="wing">Length, width, outline and direction.</param>
    /// <param name="scale">Factor from the blueprint's metres to those of <paramref name="skin"/>.</param>
    /// <param name="membrane">Linear RGB between the veins.</param>
    /// <param name="vein">Linear RGB of the veins.</param>
    public static void Append(PieceBuilder builder, SurfacePoint skin, InsectWingBlueprint wing, float scale, Vector3 membrane, Vector3 vein)
    {
        ThinWingForm? form = ThinWingForm.Of(wing.Style);
        ReadOnlySpan<float> blade = stackalloc float[] { 0f, 0.03f, 0.07f, 0.13f, 0.19f, 0.27f, 0.35f, 0.445f, 0.54f, 0.635f, 0.73f, 0.82f, 0.90f, 0.96f, 0.99f, 1f };
        int rows = form?.Rows ?? blade.Length;
        ReadOnlySpan<float> lines = stackalloc float[Lines] { 0f, 0.06f, 0.28f, 0.305f, 0.52f, 0.545f, 0.75f, 0.93f, 1f };
        float length = (float)wing.Length * scale;
        float width = (float)wing.Width * scale;
        float aspect = width / length;
        Vector3 along = Direction(wing);
        Vector3 back = ThinWingBlade.Trailing(along);
        Vector3 up = Vec.Cross(along, back);
        Vector3 root = skin.Position - (skin.Normal * (RootDepth * scale));

        Span<float> stations = stackalloc float[rows];
        Span<Vector3> grid = stackalloc Vector3[rows * Lines];
        for (int i = 0; i < rows; i++)
        {
            stations[i] = form is null ? blade[i] : i / (rows - 1f);
            Outline(stations[i], aspect, out float lead, out float trail);
            for (int j = 0; j < Lines; j++)
            {
                float u = lines[j];
                float camber = Camber * width * (trail - lead) * 4f * u * (1f - u);
                float x = stations[i];
                float y = Scalar.Lerp(lead, trail, u);
                if (form != null)
                {
                    WingPoint p = form.At(i, u);
                    x = (float)p.X;
                    y = (float)(-p.Y / form.Depth);
                }

                Vector3 place = root + (along * (x * length)) + (back * (width * y)) + (up * camber);
                grid[(i * Lines) + j] = BesideMidline(place, root, length);
            }
        }

        float thickness = 0.004f * scale;
        AppendLayer(builder, grid, stations, lines, up, thickness, aspect, membrane, vein);
        AppendLayer(builder, grid, stations, lines, up, -thickness, aspect, membrane, vein);
    }

    /// <summary>A place of a left wing, off the midline: hind wings, and those laid over the back, would push through one another.</summary>
    private static Vector3 BesideMidline(Vector3 place, Vector3 root, float length)
    {
        float min = (0.5f * root.X) + (OffMidline * Math.Max(0f, place.Y - root.Y));
        float off = place.X - min;
        float soft = Math.Min(Softness * length, Vec.Distance(place, root));
        return place with { X = min + ((off + (float)Math.Sqrt((off * off) + (soft * soft))) / 2f) };
    }

    /// <summary>Root, middle and tip of the wing's axis, its joints.</summary>
    public static Vector3[] JointPoints(SurfacePoint skin, InsectWingBlueprint wing, float scale)
    {
        Vector3 reach = Direction(wing) * ((float)wing.Length * scale);
        return new[] { skin.Position, skin.Position + (reach * 0.5f), skin.Position + reach };
    }

    private static void AppendLayer(
        PieceBuilder builder, ReadOnlySpan<Vector3> grid, ReadOnlySpan<float> stations, ReadOnlySpan<float> lines, Vector3 up, float thickness, float aspect, Vector3 membrane, Vector3 vein)
    {
        const int RowLength = 2 * Strips;
        int rows = stations.Length;
        int first = builder.VertexCount;
        float side = thickness > 0f ? 1f : -1f;
        float broad = Broadness(aspect);
        for (int i = 0; i < rows; i++)
        {
            for (int strip = 0; strip < Strips; strip++)
            {
                for (int edge = 0; edge < 2; edge++)
                {
                    // Every strip has vertices of its own, so that veins have sharp borders.
                    int j = strip + edge;
                    bool border = i == 0 || i == rows - 1 || j == 0 || j == Lines - 1;
                    Vector3 position = grid[(i * Lines) + j] + (up * (border ? 0f : thickness));
                    builder.Vertex(position, Normal(grid, i, j) * side, Shade(strip, stations[i], lines[j], BandAt(i, broad < 1f ? strip : 0), broad, membrane, vein));
                }
            }
        }

        for (int strip = 0; strip < Strips; strip++)
        {
            for (int i = 0; i + 1 < rows; i++)
            {
                int a = first + (i * RowLength) + (2 * strip);
                int b = thickness > 0f ? a + RowLength : a + 1;
                int c = a + RowLength + 1;
                int d = thickness > 0f ? a + 1 : a + RowLength;

                // At the corners of the leaf the diagonal has to leave the border, or both layers would share it.
                if ((i == 0 && strip == Strips - 1) || (i == rows - 2 && strip == 0))
                {
                    builder.Quad(b, c, d, a);
                }
                else
                {
                    builder.Quad(a, b, c, d);
                }
            }
        }
    }

    private static Vector3 Normal(ReadOnlySpan<Vector3> grid, int i, int j)
    {
        Vector3 alongRow = grid[(Math.Min(i + 1, (grid.Length / Lines) - 1) * Lines) + j] - grid[(Math.Max(i - 1, 0) * Lines) + j];
        Vector3 acrossRow = grid[(i * Lines) + Math.Min(j + 1, Lines - 1)] - grid[(i * Lines) + Math.Max(j - 1, 0)];
        return Vec.Normalize(Vec.Cross(alongRow / Vec.Length(alongRow), acrossRow / Vec.Length(acrossRow)));
    }

    /// <summary>The colour of a vertex.</summary>
    /// <param name="strip">Strip of the leaf, from the leading edge.</param>
    /// <param name="s">Station along the wing, 0..1.</param>
    /// <param name="u">0 at the leading edge, 1 at the trailing one.</param>
    /// <param name="band">How far it lies on a dark band across the wing, 0..1.</param>
    /// <param name="broad">How broad the wing is, 0..1.</param>
    /// <param name="membrane">Linear RGB between the veins.</param>
    /// <param name="vein">Linear RGB of the veins.</param>
    private static Vector3 Shade(int strip, float s, float u, float band, float broad, Vector3 membrane, Vector3 vein)
    {
        if (strip is 0 or 2 or 4)
        {
            return vein * (1f - (0.15f * s));
        }

        float dark = Scalar.Lerp(CrossVein, BandOfBroad, broad) * band;
        dark = Math.Max(dark, 0.45f * Scalar.Smooth((u - 0.8f) / 0.2f));
        if (strip == 1)
        {
            // The pterostigma, a dark cell near the tip of the leading edge.
            dark = Math.Max(dark, 0.85f * (1f - broad) * Scalar.Smooth(1f - (Math.Abs(s - 0.77f) / 0.12f)));
        }

        float margin = Math.Max(Scalar.Smooth((s - 0.74f) / 0.14f), strip == Strips - 1 ? 1f : 0.5f * Scalar.Smooth((u - 0.6f) / 0.4f));
        dark = Math.Max(dark, 0.95f * broad * margin);
        Vector3 sheen = membrane * (1f - (0.12f * s));

        // The pale patch in the middle of a butterfly's wing, and pale dots along its margin.
        float patch = strip is 3 or 5 or 6 ? Scalar.Smooth(1f - (Math.Abs(s - 0.52f) / PatchLength)) * Math.Max(0f, 1f - (Math.Abs(u - PatchLine) / PatchWidth)) : 0f;
        patch = strip == 6 ? Math.Max(patch, 0.5f * (1f - band) * Scalar.Smooth((0.9f - u) / 0.2f)) : patch;
        sheen = Vec.Lerp(sheen, Vec.Lerp(membrane, Vector3.One, 0.75f), broad * patch);
        return Vec.Lerp(sheen, vein, dark);
    }

    /// <summary>How far a station lies on a dark band across a strip, 0..1.</summary>
    private static float BandAt(int station, int strip) => Math.Abs((2f * ((station + (Band * (strip / 2) / 2)) % Band)) - Band) / Band;

    private static float Broadness(float aspect) => Scalar.Smooth((aspect - 0.32f) / 0.20f);

    // Leading and trailing edge at s along the wing, in widths behind the axis.
    private static void Outline(float s, float aspect, out float lead, out float trail)
    {
        float broad = Broadness(aspect);
        float lobe = Hinge + ((Broadest - Hinge) * Scalar.Smooth(s / BroadestAt));
        float fan = (0.16f + (0.86f * Power(s, 0.7))) * (1f - (0.58f * Scalar.Smooth((s - 0.6f) / 0.4f)));
        lead = Scalar.Lerp(-Bow * Scalar.Smooth(s / BroadestAt), -0.28f * Power(Sine(Power(s, 1.5)), 0.8), broad);
        trail = Scalar.Lerp(lobe, fan, broad);

        // It stands on a base, not on a point.
        trail += Base * (1f - s) * (1f - s) * (1f - s);

        // Both edges run round into the tip, as half an ellipse does: two straight ones are the point of a knife.
        float beyond = Math.Max(0f, (s - RoundFrom) / (1f - RoundFrom));
        float ellipse = (float)Math.Sqrt(1f - (0.99f * beyond * beyond));
        float round = Scalar.Lerp(ellipse, (float)Math.Sqrt(1f - (0.99f * Power(s, 3.5))), broad);
        float middle = Scalar.Lerp(lead, trail, 0.4f);
        lead = Scalar.Lerp(middle, lead, round);
        trail = Scalar.Lerp(middle, trail, round);
    }

    private static float Sine(float halfTurns) => (float)PortableMath.Sin(PortableMath.Pi * Math.Min(1f, halfTurns));

    private static float Power(float x, double exponent) => x <= 0f ? 0f : (float)PortableMath.Pow(x, exponent);

    private static Vector3 Direction(InsectWingBlueprint wing)
    {
        float level = (float)PortableMath.Cos(wing.Elevation);
        return new Vector3(
            (float)PortableMath.Cos(wing.Azimuth) * level,
            (float)PortableMath.Sin(wing.Elevation),
            (float)PortableMath.Sin(wing.Azimuth) * level);
    }
}
