using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class TailShaperTests
{
    private const double Stalk = 0.05;
    private const double ThickStalk = 0.2;
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

    [Theory]
    [InlineData(TailStyle.Fan)]
    [InlineData(TailStyle.Fork)]
    [InlineData(TailStyle.Lunate)]
    [InlineData(TailStyle.Fluke)]
    public void The_stalk_of_a_fin_on_a_long_tail_is_no_thread_before_the_fin_opens(TailStyle style)
    {
        double[] heights = Heights(style, LongStep, ThickStalk);
        for (int ring = StationRing.TailFirst; ring <= Last - 3; ring++)
        {
            Assert.True(heights[ring] > 0.5 * ThickStalk, FormattableString.Invariant($"{heights[ring] / ThickStalk:0.00} of its root at ring {ring}"));
            Assert.True(heights[ring] <= heights[StationRing.TailFirst]);
        }
    }

    [Fact]
    public void A_fluke_is_a_lens_from_the_side_and_thin_at_its_edge()
    {
        double[] heights = Heights(TailStyle.Fluke, ShortStep / 2, ThickStalk / 8);
        Assert.True(heights[Last - 2] > 1.5 * heights[Last], FormattableString.Invariant($"{heights[Last - 2]} m before {heights[Last]} m"));
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

    [Fact]
    public void A_fan_of_feathers_is_arched_from_edge_to_edge()
    {
        int fans = 0;
        for (ulong seed = 22259300; seed < 22259340; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (creature.Tail.Style == TailStyle.Feathers)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                BodySkin skin = BodySkin.Span(shape, creature);
                float arch = Vector3.Dot(skin[Last, 0] - skin[Last, BodyGrid.Segments / 4], shape.Up(Last));
                Assert.True(arch > 0.25 * creature.Tail.Size, FormattableString.Invariant($"{seed}: {arch / creature.Tail.Size:0.00} of its half width"));
                fans++;
            }
        }

        Assert.True(fans > 3, $"{fans} fans");
    }

    [Fact]
    public void An_upright_tail_fin_is_thicker_on_its_rays_and_drawn_in_between_them()
    {
        int fins = 0;
        for (ulong seed = 23370000; seed < 23370100; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (creature.Tail.Style is not (TailStyle.Fan or TailStyle.Fork or TailStyle.Truncate))
            {
                continue;
            }

            BodySkin skin = BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature);
            for (int between = 3; between < BodyGrid.Segments / 2; between += 2)
            {
                Vector3 middle = (skin[Last, between - 1] + skin[Last, between + 1]) / 2f;
                Vector3 off = skin[Last, between] - middle;
                Assert.True(skin[Last, between].X < middle.X, $"{seed}: the skin at segment {between} is as thick as the rays beside it");
                Assert.True(between is 7 or 9 || Vector3.Dot(off, skin.Shape.Forward(Last)) > 0f, $"{seed}: the edge at segment {between} is not drawn in");
            }

            fins++;
        }

        Assert.True(fins > 2, $"{fins} fins");
    }

    /// <summary>Heights above the spine of a tail with an even stalk, metres.</summary>
    private static double[] Heights(TailStyle style, double step, double stalk = Stalk)
    {
        double[] top = Enumerable.Repeat(stalk, BodyGrid.Rings).ToArray();
        TailShaper.Shape(new TailBlueprint(style, Size, 0), Enumerable.Repeat(step, BodyGrid.Rings).ToArray(), top.ToArray(), top, top.ToArray());
        return top;
    }
}
