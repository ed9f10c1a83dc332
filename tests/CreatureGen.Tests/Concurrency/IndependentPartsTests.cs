using System;
using System.Linq;
using System.Threading;
using CreatureGen.Concurrency;
using Xunit;

namespace CreatureGen.Tests.Concurrency;

public sealed class IndependentPartsTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(1000)]
    public void Each_part_is_run_once(int count)
    {
        var runs = new int[count];
        IndependentParts.Run(count, part => Interlocked.Increment(ref runs[part]));
        Assert.All(runs, n => Assert.Equal(1, n));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(8)]
    public void What_a_part_throws_is_thrown_as_it_was(int count)
    {
        Assert.Throws<InvalidOperationException>(() => IndependentParts.Run(count, part =>
        {
            if (part == count / 2)
            {
                throw new InvalidOperationException("part");
            }
        }));
    }
}
