using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class FishSectionTests
{
    /// <summary>Broadest section of a fish half way between its spine and its ridge or keel, in its breadth at the spine: a round one is .87 broad there.</summary>
    private const double Ridge = 0.84;
    private const double Keel = 0.81;

    [Fact]
    public void The_sections_of_fish_run_together_in_a_ridge_and_a_keel()
    {
        int fish = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Swimming, CreatureOptions.Default.Strangeness, 13870001, 60))
        {
            if (creature.Plan != BodyPlan.Fish || creature.Body.Disc.Sweep != 0)
            {
                continue;
            }

            for (int ring = StationRing.Shoulder; ring < StationRing.TorsoLast; ring++)
            {
                (double ridge, double keel) = (HalfWay(shape.TopExponent[ring]), HalfWay(shape.BottomExponent[ring]));
                Assert.True(ridge < Ridge, FormattableString.Invariant($"{creature.Seed}, ring {ring}: {ridge:0.00} broad half way to its ridge"));
                Assert.True(keel < Keel, FormattableString.Invariant($"{creature.Seed}, ring {ring}: {keel:0.00} broad half way to its keel"));
            }

            fish++;
        }

        Assert.True(fish > 8);
    }

    /// <summary>Breadth of a superellipse at half its height, in its breadth at its middle.</summary>
    private static double HalfWay(double exponent) => Math.Pow(1 - Math.Pow(0.5, exponent), 1 / exponent);
}
