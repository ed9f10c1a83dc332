using System;
using System.Linq;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class ViewTests
{
    [Theory]
    [InlineData("three-quarter", View.ThreeQuarter)]
    [InlineData("side", View.Side)]
    [InlineData("front", View.Front)]
    [InlineData("back", View.Back)]
    [InlineData("top", View.Top)]
    public void Every_word_finds_its_view_and_back(string word, View view)
    {
        Assert.True(Views.TryParse(word, out View found));
        Assert.Equal(view, found);
        Assert.Equal(word, Views.Word(view));
    }

    [Fact]
    public void Every_view_has_a_word_and_an_angle()
    {
        Assert.Equal(5, Enum.GetValues<View>().Select(Views.Word).Distinct(StringComparer.Ordinal).Count());
        Assert.Equal(5, Enum.GetValues<View>().Select(Views.Angle).Distinct().Count());
    }

    [Theory]
    [InlineData("")]
    [InlineData("Side")]
    [InlineData("side ")]
    [InlineData("bottom")]
    [InlineData("threequarter")]
    public void Other_words_find_nothing(string word) => Assert.False(Views.TryParse(word, out _));

    [Theory]
    [InlineData((View)5)]
    [InlineData((View)(-1))]
    public void Numbers_that_are_no_view_are_refused(View view)
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Views.Angle(view));
        Assert.Throws<ArgumentOutOfRangeException>(() => Views.Word(view));
    }
}
