using System.IO;
using System.Linq;
using CreatureGen.Blocks;
using CreatureGen.Preview.Pictures;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.BlockSamples;

public sealed class BlockSamplesTests
{
    [Theory]
    [InlineData("Gecko")]
    [InlineData("Chains", Explicit = true)]
    [InlineData("Ponytail", Explicit = true)]
    [InlineData("Blends", Explicit = true)]
    [InlineData("Puppet")]
    [InlineData("Hound")]
    [InlineData("Stranger")]
    [InlineData("Borrowed")]
    [InlineData("Guest", Explicit = true)]
    public void Every_sample_is_short_and_draws_six_different_frames(string sample)
    {
        Picture strip = sample switch
        {
            "Gecko" => Gecko.Strip(),
            "Chains" => Chains.Strip(),
            "Blends" => Blends.Strip(),
            "Puppet" => Puppet.Strip(),
            "Hound" => Hound.Strip(),
            "Stranger" => Stranger.Strip(),
            "Borrowed" => Borrowed.Strip(),
            "Guest" => Guest.Strip(),
            _ => Ponytail.Strip(),
        };
        int side = strip.Height;
        Assert.Equal(6 * side, strip.Width);
        int[] inks = Enumerable.Range(0, 6).Select(frame => Hash(strip, frame * side, side)).ToArray();
        Assert.Equal(6, inks.Distinct().Count());
        AssertShort(sample);
    }

    [Fact]
    public void The_sample_of_events_is_short_and_marks_a_footstep_of_each_leg()
    {
        Picture plot = Footfalls.Plot();
        AssertShort("Footfalls");
        int marked = Enumerable.Range(0, plot.Height / 56).Count(row => Enumerable.Range(0, plot.Width).Any(x => plot[x, (row * 56) + 50] is { R: > 200, G: < 100 }));
        Assert.InRange(marked, 4, plot.Height / 56);
    }

    private static void AssertShort(string sample)
    {
        string file = RepositoryFiles.Below("samples", "*.cs").Single(path => Path.GetFileName(path) == sample + ".cs");
        Assert.InRange(RepositoryFiles.Text(file).Count(c => c == '\n'), 1, 59);
    }

    /// <summary>A number for what is drawn in a frame, which is more than an empty studio.</summary>
    private static int Hash(Picture picture, int left, int side)
    {
        int hash = 0;
        int coloured = 0;
        for (int y = 0; y < side; y++)
        {
            for (int x = 0; x < side; x++)
            {
                Pixel pixel = picture[left + x, y];
                hash = unchecked((hash * 31) + pixel.R);
                coloured += pixel.R > pixel.B + 20 ? 1 : 0;
            }
        }

        Assert.True(coloured > 0.01f * side * side, $"{coloured} coloured pixels");
        return hash;
    }
}
