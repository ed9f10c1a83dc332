using CreatureGen.Maths;
using CreatureGen.Motion.Winged;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

public sealed class WingBeatTests
{
    /// <summary>Wings that push down against the air take longer than wings that are drawn up folded.</summary>
    [Fact]
    public void The_downstroke_takes_longer_than_the_upstroke()
    {
        int down = 0;
        const int Steps = 1000;
        for (int i = 0; i < Steps; i++)
        {
            down += WingBeat.At((i + 0.5) / Steps).Sine > 0 ? 1 : 0;
        }

        Assert.InRange(down / (double)Steps, 0.54, 0.60);
    }

    [Fact]
    public void A_beat_begins_at_the_top_and_ends_there()
    {
        Assert.Equal(1, WingBeat.At(0).Height, 12);
        Assert.Equal(1, WingBeat.At(1).Height, 12);
        Assert.Equal(2 * PortableMath.Pi, WingBeat.Angle(1), 12);
        Assert.True(WingBeat.At(0.25) is { Down: > 0.5, Up: 0 });
        Assert.True(WingBeat.At(0.8) is { Down: 0, Up: > 0.5 });
    }
}
