using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class TailShaperTests
{
    private const double Stalk = 0.05;
    private const double Size = 0.2;
    private const double LongStep = 0.2;
    private const double ShortStep = 0.05;
    private const int Last = BodyGrid.Rings - 1;

    [Theory]
    [InlineData(TailStyle.Fan)]
    [InlineData(TailStyle.Fork)]
    [InlineData(TailStyle.Truncate)]
    [InlineData(TailStyle.Veil)]
    public void A_fin_on_a_long_tail_opens_within_three_of_its_sizes(TailStyle style)
    {
        double[] heights = Heights(style, LongStep);
        Assert.All(Enumerable.Range(StationRing.TailFirst, Last - 3 - StationRing.TailFirst + 1), ring => Assert.InRange(heights[ring], 0, Stalk));
        Assert.True(heights[Last - 1] > 1.5 * Stalk && heights[Last] > heights[Last - 1]);
        Assert.Equal(Heights(style, ShortStep)[Last], heights[Last]);
    }

    [Fact]
    public void A_lance_takes_all_of_its_tail_however_long_that_is() =>
        Assert.Equal(Heights(TailStyle.Lance, ShortStep), Heights(TailStyle.Lance, LongStep));

    [Fact]
    public void A_fan_of_feathers_runs_out_to_an_edge()
    {
        double[] heights = Heights(TailStyle.Feathers, ShortStep);
        Assert.True(heights[Last] < 0.7 * heights[Last - 2], FormattableString.Invariant($"{heights[Last]} of {heights[Last - 2]} m"));
        Assert.All(Enumerable.Range(StationRing.TailFirst, Last - StationRing.TailFirst), ring => Assert.True(heights[ring + 1] <= heights[ring]));
    }

    /// <summary>Heights above the spine of a tail with an even stalk, metres.</summary>
    private static double[] Heights(TailStyle style, double step)
    {
        double[] top = Enumerable.Repeat(Stalk, BodyGrid.Rings).ToArray();
        TailShaper.Shape(new TailBlueprint(style, Size, 0), Enumerable.Repeat(step, BodyGrid.Rings).ToArray(), top.ToArray(), top, top.ToArray());
        return top;
    }
}
