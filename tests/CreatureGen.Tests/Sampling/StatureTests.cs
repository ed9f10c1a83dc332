using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class StatureTests
{
    /// <summary>Least standard deviation of the breadth of swimmers at the default: that of the draw is 0.12.</summary>
    private const double Spread = 0.06;

    /// <summary>Least standard deviation of the depth of swimmers at the default.</summary>
    private const double SpreadOfDepths = 0.147;

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
        double[] widths = Swimmers(body => body.Width);
        Assert.InRange(Deviation(widths), Spread, 4 * Spread);
    }

    /// <summary>.139 where the depth was drawn with a deviation of .16: half a sheet had the outline of an eel.</summary>
    [Fact]
    public void Mixed_swimmers_are_flat_and_deep_beside_one_another() => Assert.InRange(Deviation(Swimmers(body => body.Depth)), SpreadOfDepths, 2 * SpreadOfDepths);

    private static double[] Swimmers(Func<BodyProportions, double> measure)
    {
        double[] found = new double[60];
        for (int i = 0; i < found.Length; i++)
        {
            found[i] = measure(BlueprintSampler.Sample(9971001UL + (ulong)i, LocomotionKind.Swimming).Body.Proportions);
        }

        return found;
    }

    private static double Deviation(double[] values)
    {
        double mean = values.Average();
        return Math.Sqrt(values.Average(value => (value - mean) * (value - mean)));
    }
}
