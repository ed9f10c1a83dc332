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
    // Radii of the shell, in radii of the eyeball: so far out that no flat side of it cuts into the cornea when the lid lies over it. The shut upper lid overlaps the lower at the corners.
    private const float UpperRadius = 1.2f;
    private const float LowerRadius = 1.115f;
    private const float EdgeRadius = 1.055f;
    private const float UpperRim = 1.12f;
    private const float LowerRim = 1.09f;

    // Width of the dark rim, radians.
    private const float RimWidth = 0.05f;

    // How far the shell goes around the hinge, radians from the gaze: far enough to stay below the skin in a blink.
    private const float UpperBack = 3.7f;
    private const float LowerBack = 2.9f;

    /// <summary>Share of the lower opening that the upper lid closes: it comes down far, the lower one comes up a little.</summary>
    private const float UpperFraction = 0.35f;

    // How far shut lids overlap between the corners, radians.
    private const float Overlap = 0.12f;

    // Where the shell ends along the hinge, radians of latitude.
    private const float EndLatitude = 1.50f;
    private const float LargestOpening = 1.40f;
    private const float CornerMargin = 0.09f;
    private const float CornerOverlap = 0.07f;
    private const int OpeningColumns = 10;
    private const int Columns = OpeningColumns + 2;
    private const int Profile = 6;

    // Where the rows behind the rim lie, as shares of the way from the rim to the back.
    private const float FirstRow = 0.22f;
    private const float SecondRow = 0.55f;

    /// <summary>The unit axis through <see cref="EyeFrame.Centre"/> about which the lids of the left eye turn.</summary>
    public static Vector3 Hinge(in EyeFrame frame, EyeBlueprint eye) => frame.Rolled(eye.LidTilt).Outward;

    /// <summary>How far a lid turns about the hinge until the eye is shut, radians, not negative.</summary>
    public static float Closing(EyeBlueprint eye, LidPart part) => part == LidPart.Upper
        ? Opening(eye.UpperLid) + (UpperFraction * Opening(eye.LowerLid)) + Overlap
        : (1f - UpperFraction) * Opening(eye.LowerLid);

    /// <summary>Unit direction from the centre of the eye to the middle of a lid's rim at rest.</summary>
    public static Vector3 RimDirection(in EyeFrame frame, EyeBlueprint eye, LidPart part)
    {
        float angle = part == LidPart.Upper ? Opening(eye.UpperLid) : -Opening(eye.LowerLid);
        return (frame.Gaze * (float)PortableMath.Cos(angle)) + (frame.Rolled(eye.LidTilt).Up * (float)PortableMath.Sin(angle));
    }

    /// <summary>Appends a lid of the left eye.</summary>
    /// <param name="builder">Where the lid goes.</param>
    /// <param name="frame">Place, size and gaze of the eye.</param>
    /// <param name="eye">Openings of the lids and their roll.</param>
    /// <param name="part">Which lid.</param>
    /// <param name="skin">Linear RGB of the lid.</param>
    public static void Append(PieceBuilder builder, in EyeFrame frame, EyeBlueprint eye, LidPart part, Vector3 skin)
    {
        EyeFrame rolled = frame.Rolled(eye.LidTilt);
        float upper = Opening(eye.UpperLid);
        float lower = Opening(eye.LowerLid);
        float corner = Scalar.Clamp(Math.Max(upper, lower) + CornerMargin, 0.6f, LargestOpening);
        bool above = part == LidPart.Upper;
        float sign = above ? 1f : -1f;
        float opening = above ? upper : lower;
        float outer = above ? UpperRadius : LowerRadius;
        float rim = above ? UpperRim : LowerRim;
        float back = above ? UpperBack : LowerBack;
        int first = builder.VertexCount;
        Vector3 liner = skin * 0.10f;
        for (int k = 0; k <= Columns; k++)
        {
            // Columns run counter-clockwise about the gaze: outer to inner corner above, inner to outer below.
            ColumnEdge(k, corner, opening, sign, out float latitude, out float edge);
            bool seam = k == 0 || k == Columns;
            Vector3 dark = seam ? skin * 0.5f : liner;
            float start = edge + RimWidth;

            // The ends are level: rows of several radii would run through one another so near to the hinge.
            float rise = seam ? 0f : 1f;
            AddPoint(builder, rolled, latitude, edge - 0.015f, sign, rim + (rise * (EdgeRadius - rim)), dark);
            AddPoint(builder, rolled, latitude, start, sign, rim, dark);
            AddPoint(builder, rolled, latitude, start, sign, rim, skin * 0.72f);
            AddPoint(builder, rolled, latitude, start + (FirstRow * (back - start)), sign, rim + (rise * (outer - rim)), skin);
            AddPoint(builder, rolled, latitude, start + (SecondRow * (back - start)), sign, rim + (rise * (outer - rim)), skin);
            AddPoint(builder, rolled, latitude, back, sign, rim + (rise * (outer - 0.04f - rim)), skin);
        }

        AppendFaces(builder, first);
        SetNormals(builder, first);
    }

    private static float Opening(double angle) => Scalar.Clamp((float)angle, 0.05f, LargestOpening);

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
                // Rows 1 and 2 are the two sides of the edge between rim and skin.
                int j = i == Profile - 1 ? 0 : i + 1;
                if (i == Profile - 1 && k >= Columns / 2)
                {
                    // The inside is bent most near the corners: its diagonals mirror one another.
                    builder.Quad(next + j, next + i, here + i, here + j);
                }
                else if (i != 1)
                {
                    builder.Quad(here + j, next + j, next + i, here + i);
                }
            }
        }

        int last = first + (Columns * Profile);
        AppendEnd(builder, first, first + 5, first + 4, first + 3, first + 1);
        AppendEnd(builder, last, last + 1, last + 3, last + 4, last + 5);
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
                int towards = i == 0 ? Profile - 1 : i == 2 ? 0 : i - 1;
                int away = i == Profile - 1 ? 0 : i == 1 ? 3 : i + 1;
                Vector3 across = builder.Position(right + i) - builder.Position(left + i);
                Vector3 along = builder.Position(here + towards) - builder.Position(here + away);
                Vector3 normal = Vec.Cross(across / Vec.Length(across), along / Vec.Length(along));
                builder.SetNormal(here + i, Vec.Normalize(normal, Vector3.UnitY));
            }
        }
    }
}
