using System;
using System.Linq;
using CreatureGen.Preview.Pictures;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class LabelTests
{
    private static readonly Pixel ink = new(255, 255, 255);

    [Theory]
    [InlineData(LabelSize.Small)]
    [InlineData(LabelSize.Medium)]
    [InlineData(LabelSize.Large)]
    public void Ink_fills_the_width_that_was_measured_and_no_more(LabelSize size)
    {
        // The first and the last letter have ink at their outer edges, and H reaches from the top to the base line.
        const string Text = "H seed 42 H";
        int width = Label.Width(Text, size);
        var picture = new Picture(width + 20, 60, PixelLayout.Rgb);
        Label.Draw(picture, Text, 10, 5, size, ink);
        int[] columns = Enumerable.Range(0, picture.Width).Where(x => Enumerable.Range(0, 60).Any(y => picture[x, y] == ink)).ToArray();
        int[] rows = Enumerable.Range(0, 60).Where(y => Enumerable.Range(0, picture.Width).Any(x => picture[x, y] == ink)).ToArray();
        Assert.Equal((10, 10 + width - 1), (columns[0], columns[^1]));
        Assert.Equal((5, 5 + (7 * (int)size) - 1), (rows[0], rows[^1]));
    }

    [Fact]
    public void Every_printable_letter_but_the_space_has_ink_and_no_two_look_the_same()
    {
        string[] shapes = Enumerable.Range(' ', '~' - ' ' + 1).Select(c => Shape(((char)c).ToString())).ToArray();
        Assert.DoesNotContain('#', shapes[0]);
        Assert.All(shapes.Skip(1), s => Assert.Contains('#', s));
        Assert.Equal(shapes.Length, shapes.Distinct(StringComparer.Ordinal).Count());
    }

    [Theory]
    [InlineData("é")]
    [InlineData("\n")]
    [InlineData("\u007f")]
    public void Other_letters_are_drawn_as_a_question_mark(string letter) => Assert.Equal(Shape("?"), Shape(letter));

    [Theory]
    [InlineData(LabelSize.Small)]
    [InlineData(LabelSize.Medium)]
    public void A_text_is_cut_to_the_longest_start_that_fits(LabelSize size)
    {
        const string Text = "walking quadruped, seed 18446744073709551615";
        for (int width = 0; width <= Label.Width(Text, size) + 3; width++)
        {
            string fitted = Label.Fit(Text, size, width);
            Assert.True(Label.Width(fitted, size) <= width);
            if (fitted == Text)
            {
                continue;
            }

            int letters = Math.Max(0, fitted.Length - 2);
            Assert.Equal(letters == 0 ? "" : Text[..letters] + "..", fitted);
            Assert.True(Label.Width(Text[..(letters + 1)] + "..", size) > width, $"{letters + 1} letters would fit into {width} pixels");
        }
    }

    [Fact]
    public void Text_that_leaves_the_picture_is_cut_at_its_edge()
    {
        var whole = new Picture(200, 40, PixelLayout.Rgb);
        Label.Draw(whole, "creature", 20, 10, LabelSize.Medium, ink);
        var small = new Picture(50, 12, PixelLayout.Rgb);
        Label.Draw(small, "creature", 20 - 30, 10 - 15, LabelSize.Medium, ink);
        for (int y = 0; y < small.Height; y++)
        {
            for (int x = 0; x < small.Width; x++)
            {
                Assert.Equal(whole[x + 30, y + 15], small[x, y]);
            }
        }
    }

    private static string Shape(string text)
    {
        var picture = new Picture(16, 16, PixelLayout.Rgb);
        Label.Draw(picture, text, 2, 2, LabelSize.Small, ink);
        return string.Concat(Enumerable.Range(0, 256).Select(i => picture[i % 16, i / 16] == ink ? '#' : '.'));
    }
}
