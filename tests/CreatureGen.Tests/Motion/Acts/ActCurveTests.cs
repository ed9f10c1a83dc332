using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Playing;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class ActCurveTests
{
    private const double Step = 1e-3;

    private static readonly Act act = new("Bow", ActKind.Display,
        new ActPhase("crouch", 2f).To(ActChannel.ForeDown, 0.4f).To(ActChannel.NeckPitch, 0.5f).To(ActChannel.TailCurl, 1f).To(ActChannel.Aside, 1f),
        new ActPhase("down", 2f).To(ActChannel.ForeDown, 1f).To(ActChannel.NeckPitch, -0.2f),
        new ActPhase("strike", 1f, ActEase.In).To(ActChannel.ForeDown, 1.2f));

    [Fact]
    public void What_goes_on_in_one_direction_does_not_rest_where_a_phase_ends_and_what_turns_back_does()
    {
        Assert.InRange(Speed(act, 0, 1, ActChannel.ForeDown), 0.15f, 0.4f);
        Assert.Equal(Speed(act, 0, 1, ActChannel.ForeDown), Speed(act, 1, 0, ActChannel.ForeDown), 2);
        Assert.InRange(Math.Abs(Speed(act, 0, 1, ActChannel.NeckPitch)), 0f, 0.01f);
        Assert.InRange(Math.Abs(Speed(act, 0, 1, ActChannel.Aside)), 0f, 0.01f);
    }

    [Fact]
    public void It_rests_before_a_strike() => Assert.InRange(Speed(act, 1, 1, ActChannel.ForeDown), 0f, 0.01f);

    [Fact]
    public void Phases_end_where_they_say_and_nothing_goes_beyond_or_back()
    {
        Assert.Equal(0.4f, At(act, 0, 1, ActChannel.ForeDown), 5);
        Assert.Equal(1f, At(act, 1, 1, ActChannel.ForeDown), 5);
        float before = 0f;
        for (int phase = 0; phase < 2; phase++)
        {
            for (double at = 0.02; at <= 1; at += 0.02)
            {
                float now = At(act, phase, at, ActChannel.ForeDown);
                Assert.InRange(now, before - 1e-5f, 1f);
                before = now;
            }
        }
    }

    [Fact]
    public void The_end_of_a_tail_follows_the_hips_late_and_a_startled_one_at_once()
    {
        var startled = new Act("Start", ActKind.Reflex, new ActPhase("start", 2f).To(ActChannel.TailCurl, 1f).To(ActChannel.Aside, 1f));

        Assert.InRange(At(act, 0, 0.5, ActChannel.TailCurl), 0.05f, At(act, 0, 0.5, ActChannel.Aside) - 0.2f);
        Assert.Equal(1f, At(act, 1, 0.5, ActChannel.TailCurl), 5);
        Assert.Equal(At(startled, 0, 0.5, ActChannel.Aside), At(startled, 0, 0.5, ActChannel.TailCurl), 5);
    }

    private static float At(Act of, int phase, double at, ActChannel channel)
    {
        var values = new float[Act.ChannelCount];
        ActCurve.Write(of, phase, at, ActGain.Full, values);
        return values[(int)channel];
    }

    /// <summary>Per time unit, at an end of a phase.</summary>
    private static float Speed(Act of, int phase, int end, ActChannel channel)
    {
        float way = end == 1 ? At(of, phase, 1, channel) - At(of, phase, 1 - Step, channel) : At(of, phase, Step, channel) - At(of, phase, 0, channel);
        return way / (float)(Step * of.Phases[phase].Duration);
    }
}
