using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>How many cells of the body a limb grows out of.</summary>
internal static class SocketSizing
{
    /// <summary>The last segment line that a paired socket on the flank may touch: the midline of the belly is 16.</summary>
    public const int LastSegment = 15;

    /// <summary>
    /// The socket of a limb, centred as nearly as whole cells allow: twice the root's radius along and around the body, both even, grown for the toes.
    /// </summary>
    /// <param name="ring">Ring of its centre.</param>
    /// <param name="segment">Segment of its centre.</param>
    /// <param name="rootRadius">Radius of the limb's root along the body, metres.</param>
    /// <param name="sideRadius">Radius of the limb's root around the body, metres.</param>
    /// <param name="ringSpacing">Distance between rings there, metres.</param>
    /// <param name="segmentSpacing">Distance between segments there, metres.</param>
    /// <param name="toes">Number of toes that the end must be divided into; 0 for none.</param>
    /// <param name="bounds">Fewest and most cells.</param>
    public static SocketBlueprint Size(
        double ring,
        double segment,
        double rootRadius,
        double sideRadius,
        double ringSpacing,
        double segmentSpacing,
        int toes,
        SocketBounds bounds)
    {
        int rows = Cells(rootRadius, ringSpacing, bounds.MinimumRows, bounds.MaximumRows);
        int columns = Cells(sideRadius, segmentSpacing, bounds.MinimumColumns, bounds.MaximumColumns);
        while (toes >= 3 && rows + columns < (2 * toes) + 2 && (rows < bounds.MaximumRows || columns < bounds.MaximumColumns))
        {
            if (rows < bounds.MaximumRows)
            {
                rows += 2;
            }
            else
            {
                columns += 2;
            }
        }

        return Centre(ring, segment, rows, columns);
    }

    /// <summary>A paired socket of given size centred at a place of the left flank as nearly as whole cells and the ends of the body allow.</summary>
    public static SocketBlueprint Centre(double ring, double segment, int rows, int columns)
    {
        int first = Whole(ring - (0.5 * rows));
        int left = Whole(segment - (0.5 * columns));
        first = Math.Max(1, Math.Min(first, BodyGrid.Rings - 2 - rows));
        left = Math.Max(1, Math.Min(left, LastSegment - columns));
        return new SocketBlueprint(first, left, rows, columns);
    }

    /// <summary>Distance between neighbouring segments of an ellipse: its circumference, by root mean square of the half axes, over 32.</summary>
    /// <param name="width">Width of the section, metres.</param>
    /// <param name="thickness">Height of the section, metres.</param>
    public static double SegmentSpacing(double width, double thickness) =>
        PortableMath.Tau * Math.Sqrt(((width * width) + (thickness * thickness)) / 8) / BodyGrid.Segments;

    private static int Cells(double radius, double spacing, int minimum, int maximum)
    {
        double wanted = 2 * Math.Round(radius / spacing, MidpointRounding.ToEven);
        return wanted <= minimum ? minimum : wanted >= maximum ? maximum : (int)wanted;
    }

    private static int Whole(double cells) => (int)Math.Round(cells, MidpointRounding.ToEven);
}
