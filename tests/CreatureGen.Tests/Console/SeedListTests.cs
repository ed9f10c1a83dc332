using System;
using System.Linq;
using CreatureGen.Console.Arguments;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class SeedListTests
{
    [Fact]
    public void Seeds_come_in_the_order_in_which_they_are_written() =>
        Assert.Equal([7UL, 8, 9, 2, 0xBEEF, 0x10, 0x11], SeedList.Read("7-9, 2,0xbeef,0x10-0X11").ToArray());

    [Fact]
    public void The_range_of_all_seeds_is_counted_and_begun_but_never_stored()
    {
        SeedList all = SeedList.Read("0-18446744073709551615");
        Assert.Equal((UInt128)ulong.MaxValue + 1, all.Count);
        Assert.Equal([0UL, 1, 2], all.Take(3));
    }

    [Fact]
    public void A_range_that_ends_at_the_greatest_seed_ends() =>
        Assert.Equal([ulong.MaxValue - 1, ulong.MaxValue], SeedList.Read("0xFFFFFFFFFFFFFFFE-0xFFFFFFFFFFFFFFFF").ToArray());

    [Theory]
    [InlineData("", "'' is no seed")]
    [InlineData("1,,2", "'' is no seed")]
    [InlineData("1,", "'' is no seed")]
    [InlineData("-5", "'' in '-5' is no seed")]
    [InlineData("5-", "'' in '5-' is no seed")]
    [InlineData("1-2-3", "'2-3' in '1-2-3' is no seed")]
    [InlineData("1.5", "'1.5' is no seed")]
    [InlineData("+5", "'+5' is no seed")]
    [InlineData("1e3", "'1e3' is no seed")]
    [InlineData("0x", "'0x' is no seed")]
    [InlineData("0xG", "'0xG' is no seed")]
    [InlineData("18446744073709551616", "'18446744073709551616' is no seed")]
    [InlineData("0x10000000000000000", "'0x10000000000000000' is no seed")]
    [InlineData("9-3", "expected the smaller seed first, 3-9")]
    [InlineData("1-10,5", "5 is in 1-10 and in 5; expected each seed once")]
    [InlineData("4,0x4", "4 is in 4 and in 4; expected each seed once")]
    [InlineData("5-9,1-5", "5 is in 1-5 and in 5-9; expected each seed once")]
    public void What_is_no_list_is_refused_with_the_reason(string text, string reason) =>
        Assert.Contains(reason, Assert.Throws<FormatException>(() => SeedList.Read(text)).Message, StringComparison.Ordinal);

    [Fact]
    public void Lists_may_have_a_thousand_ranges_and_no_more()
    {
        Assert.Equal(1000, SeedList.Read(string.Join(',', Enumerable.Range(0, 1000))).Count());
        Assert.Contains("expected at most 1000", Assert.Throws<FormatException>(() => SeedList.Read(string.Join(',', Enumerable.Range(0, 1001)))).Message, StringComparison.Ordinal);
    }
}
