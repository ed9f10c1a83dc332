using System;
using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Tails;

/// <summary>A tail without a fin at its end, as numbers: half widths and half heights from the root to the tip, in radii of its root.</summary>
internal sealed class TailTaper
{
    private readonly MonotoneCurve width;
    private readonly MonotoneCurve height;

    /// <summary>Takes stations from the root, 0, to the tip, 1, with half width and half height at each.</summary>
    public TailTaper(params (double At, double Width, double Height)[] table)
    {
        double[] stations = Array.ConvertAll(table, row => row.At);
        width = new MonotoneCurve(stations, Array.ConvertAll(table, row => row.Width));
        height = new MonotoneCurve(stations, Array.ConvertAll(table, row => row.Height));
    }

    /// <summary>Length relative to a common tail of the same body.</summary>
    public double Length { get; init; } = 1;

    /// <summary>Thickness of the root relative to that of a common tail.</summary>
    public double Girth { get; init; } = 1;

    /// <summary>How far it rolls up over its length, degrees; negative over the back.</summary>
    public double Curl { get; init; }

    /// <summary>Depth of the furrows between its beads, as a part of its radius; a bead is two rings of the body long.</summary>
    public double Beads { get; init; }

    /// <summary>The form of a style; null for the body tables' own and for those that end in a fin or feathers.</summary>
    public static TailTaper? Of(TailStyle style) => style switch
    {
        TailStyle.Whip => WhipTail.Form,
        TailStyle.Paddle => PaddleTail.Form,
        TailStyle.Club => ClubTail.Form,
        TailStyle.Prehensile => PrehensileTail.Form,
        TailStyle.Stinger => StingerTail.Form,
        TailStyle.Saurian => SaurianTail.Form,
        _ => null,
    };

    /// <summary>Half width and half height at a share of the length.</summary>
    public (double Width, double Height) At(double s) => (width.At(s), height.At(s));
}
