using System;
using System.Linq;
using CreatureGen.Events;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class MomentsTests
{
    [Fact]
    public void Frames_of_several_bones_become_one_list_without_doubles() =>
        Assert.Equal([0, 4, 8, 10, 11], Moments.Merge([0, 4, 10, 4, 8, 11, 4]));

    [Fact]
    public void Of_five_moments_in_a_second_the_first_stays() =>
        Assert.Equal([0], Moments.Thin([0f, 0.2f, 0.4f, 0.6f, 0.8f], [1f, 1f, 5f, 1f, 1f], 1f, IntervalWinner.Earliest, 0f));

    [Fact]
    public void Of_five_moments_in_a_second_the_strongest_stays() =>
        Assert.Equal([2], Moments.Thin([0f, 0.2f, 0.4f, 0.6f, 0.8f], [1f, 1f, 5f, 1f, 1f], 1f, IntervalWinner.Strongest, 0f));

    [Fact]
    public void In_a_loop_the_last_moment_is_near_the_first()
    {
        Assert.Equal([0, 1], Moments.Thin([0.05f, 0.95f], [1f, 1f], 0.2f, IntervalWinner.Earliest, 0f));
        Assert.Equal([0], Moments.Thin([0.05f, 0.95f], [1f, 1f], 0.2f, IntervalWinner.Earliest, 1f));
    }

    [Fact]
    public void Moments_that_stay_are_never_nearer_than_the_interval_and_none_can_be_added()
    {
        var random = new Random(3);
        for (int trial = 0; trial < 200; trial++)
        {
            float[] times = Enumerable.Range(0, 30).Select(_ => random.NextSingle() * 3f).Order().ToArray();
            float[] strengths = times.Select(_ => random.NextSingle()).ToArray();
            IntervalWinner winner = trial % 2 == 0 ? IntervalWinner.Earliest : IntervalWinner.Strongest;
            var kept = Moments.Thin(times, strengths, 0.4f, winner, 3f);
            float Apart(int a, int b) => Math.Min(Math.Abs(times[a] - times[b]), 3f - Math.Abs(times[a] - times[b]));
            for (int i = 0; i < times.Length; i++)
            {
                Assert.Equal(!kept.Contains(i), kept.Any(k => k != i && Apart(k, i) < 0.4f));
            }
        }
    }

    [Fact]
    public void Intervals_that_are_none_are_refused()
    {
        Assert.Contains("an interval of -1", Assert.Throws<ArgumentException>(() => Moments.Thin([0f], [1f], -1f, IntervalWinner.Earliest, 0f)).Message, StringComparison.Ordinal);
        Assert.Contains("an interval of NaN", Assert.Throws<ArgumentException>(() => Moments.Thin([0f], [1f], float.NaN, IntervalWinner.Earliest, 0f)).Message, StringComparison.Ordinal);
        Assert.Contains("expected ascending", Assert.Throws<ArgumentException>(() => Moments.Thin([1f, 0f], [1f, 1f], 1f, IntervalWinner.Earliest, 0f)).Message, StringComparison.Ordinal);
    }
}
