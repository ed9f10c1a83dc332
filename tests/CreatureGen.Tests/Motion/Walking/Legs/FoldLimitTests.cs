using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Legs;

/// <summary>How far a hinge turns.</summary>
public sealed class FoldLimitTests
{
    [Theory]
    [InlineData(-30, 110)]
    [InlineData(-110, 35)]
    [InlineData(-5, 5)]
    [InlineData(-170, 170)]
    [InlineData(0, 120)]
    public void A_turn_ends_where_it_was_asked_to_or_at_the_end_of_the_range_on_its_way(int min, int max)
    {
        var limit = new FoldLimit(new AngleRange(Radians(min), Radians(max)));
        for (int from = min; from <= max; from += 5)
        {
            for (int turn = -177; turn <= 177; turn += 3)
            {
                PortableMath.SinCos(Radians(from), out double fromSine, out double fromCosine);
                PortableMath.SinCos(Radians(from + turn), out double sine, out double cosine);
                limit.Stop(fromCosine, fromSine, ref cosine, ref sine, 0f);
                PortableMath.SinCos(Radians(Math.Clamp(from + turn, min, max)), out double expectedSine, out double expectedCosine);
                Assert.Equal(expectedCosine, cosine, 5);
                Assert.Equal(expectedSine, sine, 5);
            }
        }
    }

    [Fact]
    public void A_turn_goes_beyond_the_end_by_no_more_than_it_may()
    {
        var limit = new FoldLimit(new AngleRange(Radians(-30), Radians(110)));
        PortableMath.SinCos(Radians(105), out double fromSine, out double fromCosine);
        PortableMath.SinCos(Radians(150), out double sine, out double cosine);
        limit.Stop(fromCosine, fromSine, ref cosine, ref sine, 0.01f);
        Assert.InRange(PortableMath.Atan2(sine, cosine) - Radians(110), 0.005, 0.0101);
    }

    private static float Radians(int degrees) => (float)(degrees * PortableMath.Pi / 180);
}
