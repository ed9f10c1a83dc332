using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using CreatureGen.Console.Working;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class OrderedWorkTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    public void Results_come_in_the_order_of_their_inputs(int threads)
    {
        var results = new List<int>();
        OrderedWork<int, int>.Run(Enumerable.Range(0, 2000), threads, i =>
        {
            Thread.SpinWait(i % 13 * 50);
            return i * 2;
        }, results.Add, TestContext.Current.CancellationToken);
        Assert.Equal(Enumerable.Range(0, 2000).Select(i => i * 2), results);
    }

    [Fact]
    public void Inputs_are_taken_only_a_little_ahead_of_the_results()
    {
        int taken = 0;
        int done = 0;
        int max = 0;
        OrderedWork<int, int>.Run(Enumerable.Range(0, 5000).Select(i =>
        {
            taken++;
            max = Math.Max(max, taken - done);
            return i;
        }), 4, i => i, _ => done++, TestContext.Current.CancellationToken);
        Assert.Equal(5000, done);
        Assert.InRange(max, 1, (4 * 16) + 1);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void The_first_failure_ends_endless_work_and_is_thrown_as_it_is(int threads)
    {
        var results = new List<int>();
        var failure = Assert.Throws<FormatException>(() => OrderedWork<int, int>.Run(Endless(), threads, i => i < 100 ? i : throw new FormatException("at " + i), results.Add, TestContext.Current.CancellationToken));
        Assert.Equal("at 100", failure.Message);
        Assert.Equal(Enumerable.Range(0, 100), results);
    }

    [Fact]
    public void A_failure_of_the_receiver_or_of_the_inputs_ends_the_work_too()
    {
        Assert.Throws<FormatException>(() => OrderedWork<int, int>.Run(Endless(), 3, i => i, i => throw new FormatException(), TestContext.Current.CancellationToken));
        Assert.Throws<FormatException>(() => OrderedWork<int, int>.Run(Endless().Select(i => i < 50 ? i : throw new FormatException()), 3, i => i, _ => { }, TestContext.Current.CancellationToken));
    }

    [Fact]
    public void Endless_work_can_be_stopped()
    {
        using var stop = new CancellationTokenSource();
        Assert.ThrowsAny<OperationCanceledException>(() => OrderedWork<int, int>.Run(Endless(), 3, i => i, i =>
        {
            if (i == 500)
            {
                stop.Cancel();
            }
        }, stop.Token));
    }

    private static IEnumerable<int> Endless()
    {
        for (int i = 0; ; i++)
        {
            yield return i;
        }
    }
}
