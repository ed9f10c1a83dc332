using System;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;

namespace CreatureGen.Sampling.Shapes;

/// <summary>What the eye takes a trunk's outline by, measured at its landmarks.</summary>
/// <param name="Chest">Greatest depth at the ribs, metres.</param>
/// <param name="Loin">Depth of the loin, metres.</param>
/// <param name="Length">From the base of the neck to the pelvis along the spine, metres.</param>
/// <param name="Depth">Greatest depth of a section between the girdles, metres.</param>
/// <param name="Breadth">Greatest breadth of a section between the girdles against its own depth.</param>
internal readonly record struct TrunkOutline(double Chest, double Loin, double Length, double Depth, double Breadth)
{
    /// <summary>Depth of the loin in chests: near 1 the line of the belly is straight. Half in a dog, three quarters in a horse, nine tenths in a rhinoceros.</summary>
    public double Tuck => Loin / Chest;

    /// <summary>Length in chests: two in a horse, three in a lizard, five in a snake.</summary>
    public double Slenderness => Length / Chest;

    /// <summary>The outline of a body.</summary>
    public static TrunkOutline Of(BodyShape shape)
    {
        double chest = 0;
        double greatest = 0;
        double breadth = 0;
        for (int ring = StationRing.Shoulder; ring <= StationRing.Pelvis; ring++)
        {
            double depth = shape.Top[ring] + shape.Bottom[ring];
            chest = ring < StationRing.Belly ? Math.Max(chest, depth) : chest;
            greatest = Math.Max(greatest, depth);
            breadth = Math.Max(breadth, 2 * shape.Width[ring] / depth);
        }

        double loin = shape.Top[StationRing.Loin] + shape.Bottom[StationRing.Loin];
        return new TrunkOutline(chest, loin, shape.Arc[StationRing.Pelvis] - shape.Arc[StationRing.NeckBase], greatest, breadth);
    }
}
