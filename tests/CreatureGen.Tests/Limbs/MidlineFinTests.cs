using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class MidlineFinTests
{
    /// <summary>Part of the base over which its end is looked at: a row of a short fin.</summary>
    private const double Row = 0.125;

    [Theory]
    [InlineData(FinStyle.Carp)]
    [InlineData(FinStyle.Tuna)]
    [InlineData(FinStyle.Ray)]
    public void Fins_whose_rays_are_of_their_own_heights_run_out_behind_and_are_not_cut_off_upright(FinStyle style)
    {
        MidlineFin form = MidlineFin.Of(style)!;
        Assert.True(form.HeightAt(0) <= 0.1);
        Assert.True(form.HeightAt(1) <= 0.05);
        Assert.True(form.HeightAt(1 - Row) < 0.5);
    }

    [Fact]
    public void The_edge_of_a_veil_is_round_and_its_last_ray_less_than_half_as_high_as_the_highest()
    {
        MidlineFin veil = MidlineFin.Of(FinStyle.Veil)!;
        double[] heights = [.. Enumerable.Range(0, 9).Select(i => veil.HeightAt(i / 8.0))];
        Assert.True(heights[8] < 0.5 * heights.Max());
        Assert.True(heights[0] < 0.6 * heights.Max());
        for (int i = 1; i < 8; i++)
        {
            Assert.True(heights[i] > ((heights[i - 1] + heights[i + 1]) / 2) - 0.03, FormattableString.Invariant($"hollow at {i} of 8"));
        }
    }
}
