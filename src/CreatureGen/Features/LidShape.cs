using System;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Upper or lower lid of an eye.</summary>
internal enum LidPart
{
    /// <summary>The lid under the brow.</summary>
    Upper,

    /// <summary>The lid over the cheek.</summary>
    Lower,
}

/// <summary>
/// One lid: a thin closed shell around the eyeball with a dark rim along the opening.
/// </summary>
/// <remarks>
/// The shell is a visor: every column of its vertices lies on a circle about the axis through both corners of the eye (<see cref="Hinge"/>),
/// so that turning the lid about that axis blinks without stretching. A positive turn closes the upper lid, a negative one the lower.
/// </remarks>
internal static class LidShape
{
    // Radii of the shell, in radii of the eyeball. The upper lid overlaps the lower at the corners.
    private const float UpperRadius = 1.16f;
    private const float LowerRadius = 1.13f;
    private const float InnerRadius = 1.015f;
    private const float RimThickness = 0.065f;

    // Width of the dark rim, radians.
    private const float RimWidth = 0.05f;

    // How far the shell goes around the hinge, radians from the gaze: far enough to stay below the skin in a blink.
    private const float Back = 2.5f;

    // Where the shell ends along the hinge, radians of latitude.
    private const float EndLatitude = 1.50f;
    private const float LargestOpening = 1.40f;
    private const float CornerMargin = 0.09f;
    private const float CornerOverlap = 0.07f;
    private const int OpeningColumns = 10;
    private const int Columns = OpeningColumns + 2;
    private const int Profile = 6;

    /// <summary>The unit axis through <see cref="EyeFrame.Centre"/> about which the lids of the left eye turn.</summary>
    public static Vector3 Hinge(in EyeFrame frame, EyeBlueprint eye) => frame.Rolled(eye.LidTilt).Outward;

    /// <summary>Appends a lid of the left eye.</summary>
    /// <param name="builder">Where the lid goes.</param>
    /// <param name="frame">Place, size and gaze of the eye.</param>
    /// <param name="eye">Openings of the lids and their roll.</param>
    /// <param name="part">Which lid.</param>
    /// <param name="skin">Linear RGB of the lid.</param>
    public static void Append(PieceBuilder builder, in EyeFrame frame, EyeBlueprint eye, LidPart part, Vector3 skin)
    {
        EyeFrame rolled = frame.Rolled(eye.LidTilt);
        float upper = Scalar.Clamp((float)eye.UpperLid, 0.05f, LargestOpening);
        float lower = Scalar.Clamp((float)eye.LowerLid, 0.05f, LargestOpening);
        float corner = Scalar.Clamp(Math.Max(upper, lower) + CornerMargin, 0.6f, LargestOpening);
        float sign = part == LidPart.Upper ? 1f : -1f;
        float opening = part == LidPart.Upper ? upper : lower;
        float outer = part == LidPart.Upper ? UpperRadius : LowerRadius;
        int first = builder.VertexCount;
        float lift = part == LidPart.Upper ? 0.02f : 0f;
        Vector3 liner = skin * 0.10f;
        for (int k = 0; k <= Columns; k++)
        {
            // Columns run counter-clockwise about the gaze: outer to inner corner above, inner to outer below.
            ColumnEdge(k, corner, opening, sign, out float latitude, out float edge);
            bool seam = k == 0 || k == Columns;
            Vector3 rim = seam ? skin * 0.5f : liner;
            AddPoint(builder, rolled, latitude, edge + RimWidth, sign, InnerRadius, rim);
            AddPoint(builder, rolled, latitude, edge - 0.015f, sign, InnerRadius + (0.6f * RimThickness), rim);
            AddPoint(builder, rolled, latitude, edge + RimWidth, sign, InnerRadius + RimThickness + lift, rim);
            AddPoint(builder, rolled, latitude, edge + RimWidth, sign, InnerRadius + RimThickness + lift, skin * 0.72f);
            AddPoint(builder, rolled, latitude, edge + (0.5f * (Back - edge)), sign, outer, skin);
            AddPoint(builder, rolled, latitude, Back, sign, outer - 0.04f, skin);
        }

        AppendFaces(builder, first);
        SetNormals(builder, first);
    }

    private static void ColumnEdge(int column, float corner, float opening, float sign, out float latitude, out float edge)
    {
        if (column == 0 || column == Columns)
        {
            latitude = (column == 0) == (sign > 0f) ? EndLatitude : -EndLatitude;
            edge = sign > 0f ? -CornerOverlap : 0f;
            return;
        }

        // An ellipse in the equidistant chart of the gaze: as wide as the corners, as high as the opening.
        double around = PortableMath.Pi * (column - 1) / OpeningColumns;
        float across = corner * (float)PortableMath.Cos(around) * sign;
        float height = opening * (float)PortableMath.Sin(around);
        float angle = (float)Math.Sqrt((across * across) + (height * height));
        float s = (float)PortableMath.Sin(angle) / angle;
        latitude = (float)((PortableMath.Pi / 2) - PortableMath.Acos(Scalar.Clamp(across * s, -1f, 1f)));
        edge = (float)PortableMath.Atan2(height * s, PortableMath.Cos(angle));
        if (column == 1 || column == Columns - 1)
        {
            edge = sign > 0f ? -CornerOverlap : 0f;
        }
    }

    private static void AddPoint(PieceBuilder builder, in EyeFrame frame, float latitude, float turn, float sign, float radius, Vector3 colour)
    {
        float c = (float)PortableMath.Cos(latitude);
        Vector3 direction = (frame.Outward * (float)PortableMath.Sin(latitude))
            + (frame.Gaze * (c * (float)PortableMath.Cos(turn)))
            + (frame.Up * (c * (float)PortableMath.Sin(turn) * sign));
        builder.Vertex(frame.Centre + (direction * (frame.Radius * radius)), direction, colour);
    }

    private static void AppendFaces(PieceBuilder builder, int first)
    {
        for (int k = 0; k < Columns; k++)
        {
            int here = first + (k * Profile);
            int next = here + Profile;
            for (int i = 0; i < Profile; i++)
            {
                // Rows 2 and 3 are the two sides of the edge between rim and skin.
                int j = i == Profile - 1 ? 0 : i + 1;
                if (i != 2)
                {
                    builder.Quad(here + j, next + j, next + i, here + i);
                }
            }
        }

        int last = first + (Columns * Profile);
        AppendEnd(builder, first, first + 5, first + 4, first + 2, first + 1);
        AppendEnd(builder, last, last + 1, last + 2, last + 4, last + 5);
    }

    private static void AppendEnd(PieceBuilder builder, int a, int b, int c, int d, int e)
    {
        builder.Triangle(a, b, c);
        builder.Triangle(a, c, d);
        builder.Triangle(a, d, e);
    }

    private static void SetNormals(PieceBuilder builder, int first)
    {
        for (int k = 0; k <= Columns; k++)
        {
            int left = first + (Math.Max(k - 1, 0) * Profile);
            int here = first + (k * Profile);
            int right = first + (Math.Min(k + 1, Columns) * Profile);
            for (int i = 0; i < Profile; i++)
            {
                int towards = i == 0 ? Profile - 1 : i == 3 ? 1 : i - 1;
                int away = i == Profile - 1 ? 0 : i == 2 ? 4 : i + 1;
                Vector3 across = builder.Position(right + i) - builder.Position(left + i);
                Vector3 along = builder.Position(here + towards) - builder.Position(here + away);
                Vector3 normal = Vec.Cross(across / Vec.Length(across), along / Vec.Length(along));
                builder.SetNormal(here + i, Vec.Normalize(normal, Vector3.UnitY));
            }
        }
    }
}
