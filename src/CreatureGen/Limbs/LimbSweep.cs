using System;
using System.Numerics;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>One section of a swept limb.</summary>
internal readonly struct SweepFrame
{
    public SweepFrame(Vector3 centre, Vector3 fore, Vector3 across, Vector3 tangent, float foreRadius, float acrossRadius)
    {
        Centre = centre;
        Fore = fore;
        Across = across;
        Tangent = tangent;
        ForeRadius = foreRadius;
        AcrossRadius = acrossRadius;
    }

    public Vector3 Centre { get; }

    /// <summary>Direction of α = 0.</summary>
    public Vector3 Fore { get; }

    /// <summary>Direction of α = π/2.</summary>
    public Vector3 Across { get; }

    public Vector3 Tangent { get; }

    public float ForeRadius { get; }

    public float AcrossRadius { get; }
}

/// <summary>The loop of vertices that a sweep ended with and the frames of its sections.</summary>
internal sealed class SweepResult
{
    public SweepResult(int[] end, SweepFrame[] frames, float[] along, float length)
    {
        End = end;
        Frames = frames;
        Along = along;
        Length = length;
    }

    public int[] End { get; }

    public SweepFrame[] Frames { get; }

    /// <summary>0..1 path length of each section.</summary>
    public float[] Along { get; }

    /// <summary>Metres.</summary>
    public float Length { get; }

    public SweepFrame Last => Frames[Frames.Length - 1];
}

/// <summary>
/// Grows a tube of quads from a loop along a path of joints with elliptic sections.
/// </summary>
/// <remarks>
/// The frame is carried along the path by projection (a rotation-minimising frame). Guards keep the tube from folding: sections are pulled back where the path bends more sharply than
/// they are wide (offset · curvature ≤ 0.72), no column of vertices runs backwards, and points stay out of the body, above the floor, and on their own side of the sagittal plane.
/// </remarks>
internal sealed class LimbSweep
{
    /// <summary>Largest share of the radius of curvature that a section may reach towards the inside of a bend.</summary>
    private const float BendLimit = 0.72f;

    /// <summary>Least advance of a column of vertices relative to the advance of the path.</summary>
    private const float MinAdvance = 0.12f;

    /// <summary>Metres. Limbs that grow from the flank keep this distance from the sagittal plane.</summary>
    private const float MidlineGap = 0.004f;

    /// <summary>Most quads side by side in a strip.</summary>
    private const int MaxStrip = 7;

    /// <summary>Points of the path, root first.</summary>
    public Vector3[] Joints { get; set; } = Array.Empty<Vector3>();

    /// <summary>Half width towards α = 0 (X) and α = π/2 (Y) at each point of the path.</summary>
    public Vector2[] Radii { get; set; } = Array.Empty<Vector2>();

    /// <summary>Path parameters of the sections in units of joints, ascending, the first 0.</summary>
    public float[] Sections { get; set; } = Array.Empty<float>();

    /// <summary>Direction of α = π/2 at the root.</summary>
    public Vector3 Across { get; set; }

    /// <summary>Share of the path over which the loop's own outline turns into the ellipse.</summary>
    public float Blend { get; set; } = 0.35f;

    /// <summary>Height below which no point may lie; negative infinity for none.</summary>
    public float Floor { get; set; } = float.NegativeInfinity;

    /// <summary>Direction that the path is made to end in; zero to leave it.</summary>
    public Vector3 EndDirection { get; set; }

    /// <summary>Path share from which the section is turned level, so that a foot lies flat; above 1 never.</summary>
    public float LevelFrom { get; set; } = 2f;

    /// <summary>Part of the way to the level that it is turned.</summary>
    public float LevelShare { get; set; } = 1f;

    /// <summary>Depth of a groove along α = 0 in fore radii, for the cup of an ear.</summary>
    public float Groove { get; set; }

    /// <summary>How far the edges of a grooved section stand before its middle, in radii across: flat across, a blade is a line for who stands beside it.</summary>
    public float Curl { get; set; }

    /// <summary>What points have to stay out of.</summary>
    public BodyKeepOut? KeepOut { get; set; }

    /// <summary>What the vertices belong to.</summary>
    public VertexAddress Address { get; set; }

    /// <summary>Overrides <see cref="VertexAddress.Along"/> for all vertices, for toes; negative to use the path.</summary>
    public float FixedAlong { get; set; } = -1f;

    /// <summary>Adds vertices and quads to the surface.</summary>
    public SweepResult Grow(SurfaceBuilder surface, int[] loop)
    {
        int count = loop.Length;
        int sections = Sections.Length;
        var centres = new Vector3[sections];
        var radii = new Vector2[sections];
        Interpolate(centres, radii);
        float[] distance = new float[sections];
        for (int q = 1; q < sections; q++)
        {
            distance[q] = distance[q - 1] + Vec.Distance(centres[q], centres[q - 1]);
        }

        float length = distance[sections - 1];
        Vector3[] tangents = Tangents(centres);
        var root = new Vector3[count];
        for (int k = 0; k < count; k++)
        {
            root[k] = surface.Positions[loop[k]];
        }

        bool flank = SocketLoop.Mean(root).X > 0.02f;
        float[] sine = new float[count];
        float[] cosine = new float[count];
        for (int k = 0; k < count; k++)
        {
            double a = PortableMath.Tau * k / count;
            sine[k] = (float)PortableMath.Sin(a);
            cosine[k] = (float)PortableMath.Cos(a);
        }

        float girth = 0f;
        foreach (Vector2 r in radii)
        {
            girth += (r.X + r.Y) * (float)PortableMath.Pi / sections;
        }

        var frames = new SweepFrame[sections];
        float[] along = new float[sections];
        int[] previous = loop;
        int[][] loops = new int[sections][];
        loops[0] = loop;
        int chart = surface.NewChart();
        Vector3 across = Vec.Normalize(Vec.Reject(Across, tangents[0]), Vector3.UnitX);
        for (int q = 0; q < sections; q++)
        {
            along[q] = distance[q] / length;
            if (q > 0)
            {
                across = Vec.Normalize(Vec.Reject(across, tangents[q]), across);
                across = Level(across, tangents[q], along[q]);
            }

            Vector3 fore = Vec.Cross(across, tangents[q]);
            frames[q] = new SweepFrame(centres[q], fore, across, tangents[q], radii[q].X, radii[q].Y);
            if (q == 0)
            {
                continue;
            }

            Vector3 before = Curvature(tangents, distance, q - 1);
            Vector3 after = q + 1 < sections ? Curvature(tangents, distance, q) : Vector3.Zero;
            Vector3 advance = Vec.Normalize(tangents[q] + tangents[q - 1], tangents[q]);
            float min = MinAdvance * (distance[q] - distance[q - 1]);
            float blend = Blend > 0f ? Scalar.Smooth(along[q] / Blend) : 1f;
            float opened = Scalar.Smooth((along[q] - 0.12f) * 4f) * (1f - Scalar.Smooth((along[q] - 0.75f) / 0.25f));
            float groove = Groove * radii[q].X * opened;
            float curl = Curl * radii[q].Y * opened;
            int[] current = new int[count];
            for (int k = 0; k < count; k++)
            {
                Vector3 offset = (fore * (cosine[k] * radii[q].X)) + (across * (sine[k] * radii[q].Y));
                offset = PullBack(PullBack(offset, before), after);
                Vector3 p = centres[q] + offset;
                if (cosine[k] > 0f)
                {
                    p -= fore * (cosine[k] * groove);
                }

                p += fore * (curl * ((sine[k] * sine[k]) - 0.5f));
                p = Vec.Lerp(root[k] + (centres[q] - centres[0]), p, blend);
                float need = min - Vec.Dot(p - surface.Positions[previous[k]], advance);
                p += advance * Math.Max(need, 0f);
                if (KeepOut != null)
                {
                    p = KeepOut.Push(p);
                }

                p.Y = Math.Max(p.Y, Floor);
                if (flank)
                {
                    p.X = Math.Max(p.X, MidlineGap);
                }

                VertexAddress address = Address;
                VertexAddress origin = surface.Addresses[loop[k]];
                address.Along = FixedAlong >= 0f ? FixedAlong : along[q];
                address.Around = (float)(PortableMath.Tau * k / count);
                address.Ring = origin.Ring;
                address.Segment = origin.Segment;
                if (Groove > 0f && cosine[k] > 0.5f && along[q] is > 0.25f and < 0.85f)
                {
                    address.Region = SurfaceRegion.EarInside;
                }

                current[k] = surface.Add(p, address);
            }

            loops[q] = current;
            previous = current;
        }

        AddRings(surface, loops, distance, chart, girth);
        return new SweepResult(previous, frames, along, length);
    }

    /// <summary>Adds the quads between loops that follow one another; texture coordinates are (arc around, distance along), cut at α = 0.</summary>
    /// <remarks>Quads follow one another in strips along the limb, each so narrow that two rows of its vertices fit into the smallest caches of graphics cards.</remarks>
    /// <param name="surface">Where they go.</param>
    /// <param name="loops">Vertices of each loop, as many in each.</param>
    /// <param name="distance">Metres along the limb of each loop.</param>
    /// <param name="chart">Their chart.</param>
    /// <param name="girth">Metres around the limb, as the chart has it.</param>
    public static void AddRings(SurfaceBuilder surface, int[][] loops, ReadOnlySpan<float> distance, int chart, float girth)
    {
        int count = loops[0].Length;
        int strips = (count + MaxStrip - 1) / MaxStrip;
        for (int strip = 0; strip < strips; strip++)
        {
            int end = count * (strip + 1) / strips;
            for (int q = 1; q < loops.Length; q++)
            {
                int[] previous = loops[q - 1];
                int[] current = loops[q];
                for (int k = count * strip / strips; k < end; k++)
                {
                    int next = (k + 1) % count;
                    var near = new Vector2(girth * k / count, distance[q - 1]);
                    var far = new Vector2(girth * (k + 1) / count, distance[q]);
                    surface.Quad(previous[k], previous[next], current[next], current[k], chart, new FaceTexcoords(near, new Vector2(far.X, near.Y), far, new Vector2(near.X, far.Y)));
                }
            }
        }
    }

    private static Vector3 Curvature(Vector3[] tangents, float[] distance, int q) =>
        (tangents[q + 1] - tangents[q]) / Math.Max(distance[q + 1] - distance[q], 1e-6f);

    private static Vector3 PullBack(Vector3 offset, Vector3 curvature)
    {
        float excess = Vec.Dot(offset, curvature) - BendLimit;
        float squared = Vec.LengthSquared(curvature);
        return excess > 0f && squared > 1e-12f ? offset - (curvature * (excess / squared)) : offset;
    }

    private Vector3 Level(Vector3 across, Vector3 tangent, float along)
    {
        if (along <= LevelFrom)
        {
            return across;
        }

        Vector3 level = Vec.Cross(Vector3.UnitY, tangent);
        float length = Vec.Length(level);
        if (length <= 0.2f)
        {
            return across;
        }

        level = level / length * (Vec.Dot(level, across) < 0f ? -1f : 1f);
        float weight = LevelShare * Scalar.Smooth((along - LevelFrom) / 0.25f) * Scalar.Smooth((length - 0.2f) / 0.3f);
        across = Vec.Lerp(across, level, weight);
        return Vec.Normalize(Vec.Reject(across, tangent), across);
    }

    private Vector3[] Tangents(Vector3[] centres)
    {
        int last = centres.Length - 1;
        var tangents = new Vector3[centres.Length];
        for (int q = 0; q <= last; q++)
        {
            tangents[q] = Vec.Normalize(centres[Math.Min(q + 1, last)] - centres[Math.Max(q - 1, 0)], Vector3.UnitY);
        }

        if (EndDirection != Vector3.Zero)
        {
            tangents[last] = EndDirection;
            tangents[last - 1] = Vec.Normalize((tangents[last - 1] * 0.4f) + (EndDirection * 0.6f), EndDirection);
        }

        return tangents;
    }

    /// <summary>Monotone cubics through the joints, coordinate by coordinate.</summary>
    private void Interpolate(Vector3[] centres, Vector2[] radii)
    {
        int n = Joints.Length;
        Span<double> knots = stackalloc double[n];
        Span<double> values = stackalloc double[n];
        Span<double> slopes = stackalloc double[n];
        for (int i = 0; i < n; i++)
        {
            knots[i] = i;
        }

        for (int axis = 0; axis < 5; axis++)
        {
            for (int i = 0; i < n; i++)
            {
                values[i] = axis switch { 0 => Joints[i].X, 1 => Joints[i].Y, 2 => Joints[i].Z, 3 => Radii[i].X, _ => Radii[i].Y };
            }

            MonotoneCubic.Slopes(knots, values, slopes);
            for (int q = 0; q < Sections.Length; q++)
            {
                float value = (float)MonotoneCubic.Evaluate(knots, values, slopes, Sections[q]);
                switch (axis)
                {
                    case 0: centres[q].X = value; break;
                    case 1: centres[q].Y = value; break;
                    case 2: centres[q].Z = value; break;
                    case 3: radii[q].X = value; break;
                    default: radii[q].Y = value; break;
                }
            }
        }
    }
}
