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

    /// <summary>Sharpest corner of a mixed walker's withers on its skin, degrees over four rings (51 where nothing is evened out).</summary>
    private const double SharpestWithers = 45;

    /// <summary>The same in the mean (19.3 where heights above the spine are evened out ring by ring, which lie close together before the withers).</summary>
    private const double MeanWithers = 18;

    /// <summary>Share of the first body in a torso below which it is mixed.</summary>
    private const double Mixed = 0.75;

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

    [Fact]
    public void The_withers_of_mixed_walkers_are_no_knob()
    {
        int mixed = 0;
        double sum = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, CreatureOptions.Default.Strangeness, First, Count))
        {
            if (creature.Plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar
                && creature.Body.Blend.TorsoFractions[0] < Mixed && creature.Wings.Count == 0 && creature.Body.Shell.Style == ShellStyle.None)
            {
                double knob = SharpestKnob(BodySkin.Span(shape, creature), 22, StationRing.Ribs);
                Assert.True(knob < SharpestWithers, FormattableString.Invariant($"{creature.Seed}: a corner of {knob:0} degrees"));
                sum += knob;
                mixed++;
            }
        }

        Assert.InRange(mixed, 10, Count);
        Assert.InRange(sum / mixed, 0, MeanWithers);
    }

    /// <summary>Sharpest turn down of the line of the back as it goes back, degrees.</summary>
    private static double SharpestKnob(BodySkin skin, int first, int last)
    {
        double sharpest = 0;
        for (int ring = first; ring <= last; ring++)
        {
            sharpest = Math.Max(sharpest, Rise(ring - Side) - Rise(ring));
        }

        return sharpest;

        double Rise(int ring) => 180 / Math.PI * Math.Atan2(skin[ring + Side, 0].Y - skin[ring, 0].Y, skin[ring, 0].Z - skin[ring + Side, 0].Z);
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
