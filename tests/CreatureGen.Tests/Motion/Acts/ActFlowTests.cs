using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Playing;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class ActFlowTests
{
    private const double Step = 1e-3;

    private static readonly Act act = new("Rise", ActKind.Posture,
        new ActPhase("lie", 1f).To(ActChannel.HindDown, 1f).To(ActChannel.NeckPitch, 0.1f),
        new ActPhase("prop", 2f).To(ActChannel.HindDown, 0.6f).To(ActChannel.NeckPitch, -0.4f),
        new ActPhase("stand", 2f).To(ActChannel.HindDown, 0f).To(ActChannel.NeckPitch, 0f));

    private readonly ActFlow flow = new(act, 1, ActGain.Full);

    [Fact]
    public void It_comes_through_what_phases_end_at()
    {
        Assert.Equal(4f, flow.Duration);
        Assert.Equal(1f, At(0, ActChannel.HindDown));
        Assert.Equal(0.6f, At(0.5, ActChannel.HindDown), 5);
        Assert.Equal(-0.4f, At(0.5, ActChannel.NeckPitch), 5);
        Assert.Equal(0f, At(1, ActChannel.HindDown), 5);
    }

    [Fact]
    public void It_rests_at_its_ends_and_where_a_channel_turns_back_and_nowhere_else()
    {
        Assert.InRange(Speed(0.5, ActChannel.HindDown), 0.5f, 1.5f);
        Assert.InRange(Speed(0.5, ActChannel.NeckPitch), 0f, 0.02f);
        Assert.InRange(Speed(0, ActChannel.HindDown), 0f, 0.02f);
        Assert.InRange(Speed(1, ActChannel.HindDown), 0f, 0.02f);
    }

    private float At(double at, ActChannel channel)
    {
        var values = new float[Act.ChannelCount];
        flow.Write(at, values);
        return values[(int)channel];
    }

    /// <summary>How much of it goes by in the whole time, at this speed.</summary>
    private float Speed(double at, ActChannel channel)
    {
        double from = at == 0 ? 0 : at - Step;
        double to = at == 1 ? 1 : at + Step;
        return System.Math.Abs((At(to, channel) - At(from, channel)) / (float)(to - from));
    }
}
