using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>
/// The eyeball: a bulging cornea over pupil, iris, limbal ring and dark rim, with two glints; or the faceted dome of an insect.
/// </summary>
/// <remarks>
/// Rings of vertices lie exactly on the edges of the colours and are doubled there, so that edges stay crisp at any distance without a texture.
/// An upright slit or a level bar is not laid over the iris: the rings around the gaze start as the pupil and widen to the circle of the iris.
/// </remarks>
internal static class EyeShape
{
    /// <summary>The eyeball reaches no further from its centre than this, in radii.</summary>
    public const float Bulge = 1.06f;

    private const int Segments = 20;

    // Angles from the gaze, radians.
    private const float RoundPupil = 0.48f;
    private const float SlitHalfWidth = 0.17f;
    private const float SlitHalfHeight = 0.70f;
    private const float BarHalfWidth = 0.62f;
    private const float BarHalfHeight = 0.21f;
    private const float IrisEdge = 0.86f;
    private const float LimbusEdge = 0.98f;
    private const float RimEdge = 1.13f;
    private const float BackRing = 1.85f;
    private const float CorneaEdge = 1.0f;

    // The glints, places and radii in radians from the gaze. The larger one is just within the edge of a round pupil, above a bar and beside a slit, and the small one on the iris:
    // a white disc on the edge of a pupil bites into it, and what is left of it is a C.
    private static readonly Vector2 glint = new(-0.17f, 0.28f);
    private static readonly Vector2 glintBesideSlit = new(-0.30f, 0.40f);
    private static readonly Vector2 glintAboveBar = new(-0.30f, 0.345f);
    private static readonly Vector2 counterGlint = new(0.34f, -0.52f);
    private const float GlintRadius = 0.125f;
    private const float CounterGlintRadius = 0.07f;

    /// <summary>Height of the glint on an eye on the midline with a slit, which it would cut anywhere lower.</summary>
    private const float AboveSlit = 0.84f;

    /// <summary>Shade of the back of a faceted dome against its front.</summary>
    private const float BackShade = 0.75f;

    /// <summary>How far apart the two halves of an eye on the midline may be by rounding, in radii.</summary>
    private const float Rounding = 5e-5f;

    private static readonly Vector3 pupilColour = new(0.006f, 0.006f, 0.008f);
    private static readonly Vector3 beadColour = new(0.03f, 0.026f, 0.028f);
    private static readonly Vector3 rimColour = new(0.022f, 0.018f, 0.018f);

    /// <summary>Appends the left eye.</summary>
    /// <param name="builder">Where the eye goes.</param>
    /// <param name="frame">Place, size and gaze.</param>
    /// <param name="style">How the eye is made.</param>
    /// <param name="iris">Linear RGB of the iris, or of the facets.</param>
    public static void Append(PieceBuilder builder, in EyeFrame frame, EyeStyle style, Vector3 iris) => Append(builder, frame, style, iris, rimColour);

    /// <summary>Appends the left eye.</summary>
    /// <param name="builder">Where the eye goes.</param>
    /// <param name="frame">Place, size and gaze.</param>
    /// <param name="style">How the eye is made.</param>
    /// <param name="iris">Linear RGB of the iris, or of the facets.</param>
    /// <param name="back">Linear RGB of the back of the ball, which shows behind shut lids where an eye stands far out.</param>
    public static void Append(PieceBuilder builder, in EyeFrame frame, EyeStyle style, Vector3 iris, Vector3 back)
    {
        int first = builder.VertexCount;
        AppendEye(builder, frame, style, iris, back);
        if (frame.IsMedian)
        {
            builder.Symmetrise(first, Rounding * frame.Radius);
        }
    }

    private static void AppendEye(PieceBuilder builder, in EyeFrame frame, EyeStyle style, Vector3 iris, Vector3 back)
    {
        // An eye on the midline is its own mirror image, with one glint on its middle.
        float aside = frame.IsMedian ? 0f : 1f;
        if (style == EyeStyle.Compound)
        {
            AppendCompound(builder, frame, iris);
            return;
        }

        if (style == EyeStyle.Bead)
        {
            AppendCompound(builder, frame, beadColour);
            AppendGlint(builder, frame, new Vector2(-0.20f * aside, 0.45f), 0.24f, 10, Vector3.One);
            return;
        }

        AppendBall(builder, frame, style, iris, back);
        Vector2 at = style switch
        {
            EyeStyle.Slit => frame.IsMedian ? new Vector2(0f, AboveSlit) : glintBesideSlit,
            EyeStyle.Bar => glintAboveBar,
            _ => glint,
        };
        AppendGlint(builder, frame, new Vector2(at.X * aside, at.Y), GlintRadius, 10, Vector3.One);
        if (!frame.IsMedian)
        {
            AppendGlint(builder, frame, counterGlint, CounterGlintRadius, 8, Vec.Lerp(iris, Vector3.One, 0.55f));
        }
    }

    private static void AppendBall(PieceBuilder builder, in EyeFrame frame, EyeStyle style, Vector3 iris, Vector3 socket)
    {
        Span<Vector2> pupil = stackalloc Vector2[Segments];
        Span<Vector2> inner = stackalloc Vector2[Segments];
        Span<Vector2> ring = stackalloc Vector2[Segments];
        Span<Vector2> circle = stackalloc Vector2[Segments];
        UnitCircle.Directions(Segments).CopyTo(circle);
        for (int k = 0; k < Segments; k++)
        {
            pupil[k] = style switch
            {
                // A slit pointed at both ends: its half width falls with the square of the height.
                EyeStyle.Slit => new Vector2(SlitHalfWidth * circle[k].X * Math.Abs(circle[k].X), SlitHalfHeight * circle[k].Y),

                // A bar with rounded ends, a little lower in the middle than beside it.
                EyeStyle.Bar => new Vector2(BarHalfWidth * Rounded(circle[k].X), BarHalfHeight * Rounded(circle[k].Y) * (0.86f + (0.22f * Math.Abs(circle[k].X)))),
                _ => circle[k] * RoundPupil,
            };
        }

        int pole = builder.Vertex(frame.Centre + (frame.Gaze * (frame.Radius * CorneaRadius(0f))), frame.Gaze, pupilColour);
        int a = Ring(builder, frame, pupil, pupilColour, pupilColour, 0f);
        builder.Fan(a, pole, Segments);

        // Light that falls through the cornea brightens the iris opposite to where it came from: dark under the brow, glowing below.
        Vector3 low = iris * 1.25f;
        Vector3 high = iris * 0.56f;
        a = Ring(builder, frame, pupil, low * 0.80f, high * 0.75f, 0.05f);
        Scale(circle, IrisEdge, ring);
        Mix(pupil, ring, 0.45f, inner);
        int b = Ring(builder, frame, inner, low * 1.12f, high * 1.15f, 0.10f);
        builder.Band(b, a, Segments);
        int c = Ring(builder, frame, ring, low * 0.82f, high * 0.80f, 0f);
        builder.Band(c, b, Segments);

        Vector3 limbus = iris * 0.16f;
        a = Ring(builder, frame, ring, limbus, limbus * 0.7f, 0f);
        Scale(circle, LimbusEdge, ring);
        b = Ring(builder, frame, ring, limbus * 0.6f, limbus * 0.4f, 0f);
        builder.Band(b, a, Segments);

        Vector3 white = Vec.Lerp(iris * 0.42f, new Vector3(0.30f, 0.27f, 0.25f), 0.25f);
        a = Ring(builder, frame, ring, white, white * 0.5f, 0f);
        Scale(circle, RimEdge, ring);
        b = Ring(builder, frame, ring, rimColour, rimColour, 0f);
        builder.Band(b, a, Segments);
        Scale(circle, BackRing, ring);
        c = Ring(builder, frame, ring, socket, socket, 0f);
        builder.Band(c, b, Segments);
        int back = builder.Vertex(frame.Centre - (frame.Gaze * frame.Radius), Vector3.Zero - frame.Gaze, socket);
        builder.FanBelow(c, back, Segments);
    }

    /// <summary>The square root with the sign kept: makes a circle a rounded square.</summary>
    private static float Rounded(float x) => x < 0f ? -(float)Math.Sqrt(-x) : (float)Math.Sqrt(x);

    private static void AppendCompound(PieceBuilder builder, in EyeFrame frame, Vector3 colour)
    {
        ReadOnlySpan<float> angles = stackalloc float[] { 0.36f, 0.74f, 1.10f, 1.36f, 1.36f, 1.75f, 2.35f };
        ReadOnlySpan<Vector2> circle = UnitCircle.Directions(Segments);
        var radii = new Vector3(0.95f, 1.22f, 0.85f) * frame.Radius;
        Vector3 sheen = Vec.Normalize((frame.Gaze * 0.75f) + (frame.Up * 0.55f) - (frame.Outward * 0.30f));
        int previous = -1;
        int first = builder.VertexCount;
        builder.Vertex(frame.Centre + (frame.Gaze * radii.Z), frame.Gaze, Facet(colour, 0f, 0.75f, 0));
        for (int i = 0; i < angles.Length; i++)
        {
            float across = (float)PortableMath.Sin(angles[i]);
            float along = (float)PortableMath.Cos(angles[i]);
            int ring = builder.VertexCount;
            for (int k = 0; k < Segments; k++)
            {
                Vector3 unit = new(across * circle[k].X, across * circle[k].Y, along);
                Vector3 direction = (frame.Outward * unit.X) + (frame.Up * unit.Y) + (frame.Gaze * unit.Z);
                Vector3 offset = (frame.Outward * (unit.X * radii.X)) + (frame.Up * (unit.Y * radii.Y)) + (frame.Gaze * (unit.Z * radii.Z));
                Vector3 normal = (frame.Outward * (unit.X / radii.X)) + (frame.Up * (unit.Y / radii.Y)) + (frame.Gaze * (unit.Z / radii.Z));
                Vector3 shade = i <= 3 ? Facet(colour, unit.Y, Vec.Dot(direction, sheen), i + k) : i == 4 ? rimColour : Behind(colour, unit.Y);
                builder.Vertex(frame.Centre + offset, Vec.Normalize(normal), shade);
            }

            if (previous < 0)
            {
                builder.Fan(ring, first, Segments);
            }
            else if (i != 4)
            {
                builder.Band(ring, previous, Segments);
            }

            previous = ring;
        }

        int back = builder.Vertex(frame.Centre - (frame.Gaze * radii.Z), Vector3.Zero - frame.Gaze, Behind(colour, 0f));
        builder.FanBelow(previous, back, Segments);
    }

    /// <summary>The back of a dome behind its dark rim, which is seen from behind where an eye stands out of the head: black, it is a hole.</summary>
    private static Vector3 Behind(Vector3 colour, float height) => Facet(colour, height, 0f, 0) * BackShade;

    // Facets swallow light: even the brightest are darker than an iris of the same colour.
    private static Vector3 Facet(Vector3 colour, float height, float towardsSheen, int parity)
    {
        float light = Scalar.Smooth((height + 0.55f) / 1.45f);
        float sparkle = (parity & 1) == 0 ? 1.06f : 0.94f;
        Vector3 shade = Vec.Lerp(colour * 0.10f, colour * 0.62f, light) * sparkle;
        return Saturate(Vec.Lerp(shade, Vector3.One, 0.30f * Scalar.Smooth((towardsSheen - 0.78f) / 0.22f)));
    }

    // A thin lens on the cornea: flat rim, domed outside, its underside within the eyeball.
    private static void AppendGlint(PieceBuilder builder, in EyeFrame frame, Vector2 chart, float angularRadius, int sides, Vector3 colour)
    {
        ReadOnlySpan<Vector2> circle = UnitCircle.Directions(sides);
        int rim = builder.VertexCount;
        for (int k = 0; k < sides; k++)
        {
            Vector2 at = chart + (circle[k] * angularRadius);
            builder.Vertex(SurfacePoint(frame, at, 1.008f, out Vector3 normal), normal, colour);
        }

        int top = builder.Vertex(SurfacePoint(frame, chart, 1.018f, out Vector3 outward), outward, colour);
        int bottom = builder.Vertex(SurfacePoint(frame, chart, 0.95f, out _), Vector3.Zero - outward, colour);
        builder.Fan(rim, top, sides);
        builder.FanBelow(rim, bottom, sides);
    }

    private static int Ring(PieceBuilder builder, in EyeFrame frame, ReadOnlySpan<Vector2> chart, Vector3 low, Vector3 high, float streak)
    {
        int first = builder.VertexCount;
        for (int k = 0; k < chart.Length; k++)
        {
            Vector3 position = SurfacePoint(frame, chart[k], 1f, out Vector3 normal);
            float angle = (float)Math.Sqrt((chart[k].X * chart[k].X) + (chart[k].Y * chart[k].Y));
            float height = chart[k].Y / angle * (float)PortableMath.Sin(angle);
            float fibre = (k & 1) == 0 ? 1f + streak : 1f - streak;
            builder.Vertex(position, normal, Saturate(Vec.Lerp(low, high, Scalar.Smooth((height + 0.35f) / 1.0f)) * fibre));
        }

        return first;
    }

    private static Vector3 SurfacePoint(in EyeFrame frame, Vector2 chart, float lift, out Vector3 normal)
    {
        Vector3 direction = frame.Direction(chart);
        float angle = (float)Math.Sqrt((chart.X * chart.X) + (chart.Y * chart.Y));
        float radius = CorneaRadius(angle);
        normal = direction;
        if (angle > 1e-6f && angle < CorneaEdge)
        {
            // Surface r(θ) of revolution: its normal is r·e_r − r′·e_θ, and e_θ is the gaze turned away along the meridian.
            float x = angle / CorneaEdge;
            float slope = -(Bulge - 1f) * 6f * x * (1f - x) / CorneaEdge;
            Vector3 meridian = Vec.Normalize((direction * (float)PortableMath.Cos(angle)) - frame.Gaze, direction);
            normal = Vec.Normalize((direction * radius) - (meridian * slope));
        }

        return frame.Centre + (direction * (frame.Radius * radius * lift));
    }

    private static float CorneaRadius(float angle) => 1f + ((Bulge - 1f) * (1f - Scalar.Smooth(angle / CorneaEdge)));

    private static void Scale(ReadOnlySpan<Vector2> unit, float radius, Span<Vector2> result)
    {
        for (int k = 0; k < unit.Length; k++)
        {
            result[k] = unit[k] * radius;
        }
    }

    private static void Mix(ReadOnlySpan<Vector2> from, ReadOnlySpan<Vector2> to, float t, Span<Vector2> result)
    {
        for (int k = 0; k < from.Length; k++)
        {
            result[k] = from[k] + ((to[k] - from[k]) * t);
        }
    }

    private static Vector3 Saturate(Vector3 c) => new(Scalar.Clamp(c.X, 0f, 1f), Scalar.Clamp(c.Y, 0f, 1f), Scalar.Clamp(c.Z, 0f, 1f));
}
