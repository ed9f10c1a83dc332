using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class FairOutlineTests
{
    private const ulong First = 13660001;
    private const int Count = 120;

    /// <summary>Sharpest convex corner of a mixed swimmer's belly and back, degrees over four rings (40 and 33 where nothing is evened out).</summary>
    private const double SharpestBelly = 26;
    private const double SharpestBack = 22;

    /// <summary>Rings to either side of a corner that its sides go through.</summary>
    private const int Side = 2;

    [Fact]
    public void Mixed_swimmers_have_no_corners_between_the_shoulder_and_the_tail()
    {
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Swimming, CreatureOptions.Default.Strangeness, First, Count))
        {
            if (SpeciesCatalogue.Find(creature.Body.Blend.First).Disc.Sweep == 0)
            {
                double belly = SharpestCorner(shape, -1, 24, StationRing.Pelvis);
                double back = SharpestCorner(shape, 1, 24, StationRing.Pelvis);
                Assert.True(belly < SharpestBelly, FormattableString.Invariant($"{creature.Seed}: a corner of {belly:0} degrees in its belly"));
                Assert.True(back < SharpestBack, FormattableString.Invariant($"{creature.Seed}: a corner of {back:0} degrees in its back"));
            }
        }
    }

    /// <summary>Sharpest turn of the outline inwards as it goes back, degrees.</summary>
    private static double SharpestCorner(BodyShape shape, int side, int first, int last)
    {
        double sharpest = 0;
        for (int ring = first; ring <= last; ring++)
        {
            sharpest = Math.Max(sharpest, side * (Slope(shape, side, ring - Side) - Slope(shape, side, ring)));
        }

        return sharpest;
    }

    /// <summary>How the outline rises from a ring to the one that is a side behind it, degrees.</summary>
    private static double Slope(BodyShape shape, int side, int ring)
    {
        int next = ring + Side;
        return 180 / Math.PI * Math.Atan2(Height(shape, side, next) - Height(shape, side, ring), shape.Z[ring] - shape.Z[next]);
    }

    private static double Height(BodyShape shape, int side, int ring) =>
        shape.Y[ring] + (side * Math.Cos(shape.Pitch[ring]) * (side > 0 ? shape.Top[ring] : shape.Bottom[ring]));
}
