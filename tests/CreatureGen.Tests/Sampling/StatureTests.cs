using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class StatureTests
{
    /// <summary>Least standard deviation of the breadth of swimmers at the default: that of the draw is 0.12.</summary>
    private const double Spread = 0.06;

    [Fact]
    public void Animals_on_legs_are_as_broad_and_deep_as_their_species()
    {
        for (ulong seed = 9971001; seed <= 9971040; seed++)
        {
            BodyProportions body = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0 }).Body.Proportions;
            Assert.Equal((1, 1), (body.Width, body.Depth));
        }
    }

    [Fact]
    public void Mixed_swimmers_are_slight_and_stout_beside_what_their_parents_are()
    {
        var widths = new List<double>();
        for (ulong seed = 9971001; seed <= 9971060; seed++)
        {
            widths.Add(BlueprintSampler.Sample(seed, LocomotionKind.Swimming).Body.Proportions.Width);
        }

        double mean = 0;
        widths.ForEach(width => mean += width / widths.Count);
        double square = 0;
        widths.ForEach(width => square += (width - mean) * (width - mean) / widths.Count);
        Assert.InRange(Math.Sqrt(square), Spread, 4 * Spread);
    }
}
