using System;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbDeterminismTests
{
    [Fact]
    public void The_same_creature_always_gives_the_same_bytes()
    {
        foreach (Shading shading in new[] { Shading.Smooth, Shading.Flat })
        {
            var options = new GltfOptions { Shading = shading };
            byte[] first = GlbFile.Write(SampleCreature.Build(SampleShape.Of(9)), options);
            GlbFile.Write(SampleCreature.Build(SampleShape.Of(10)), options);
            Assert.Equal(first, GlbFile.Write(SampleCreature.Build(SampleShape.Of(9)), options));
        }
    }

    [Fact]
    public void Threads_do_not_disturb_one_another()
    {
        Creature[] creatures = Enumerable.Range(0, 16).Select(i => SampleCreature.Build(SampleShape.Of(i))).ToArray();
        byte[][] alone = creatures.Select(c => GlbFile.Write(c)).ToArray();
        var together = new byte[8 * creatures.Length][];
        Parallel.For(0, together.Length, new ParallelOptions { MaxDegreeOfParallelism = 8, CancellationToken = TestContext.Current.CancellationToken }, i => together[i] = GlbFile.Write(creatures[i % creatures.Length]));
        Assert.All(Enumerable.Range(0, together.Length), i => Assert.Equal(alone[i % creatures.Length], together[i]));
    }

    [Theory]
    [InlineData("tr-TR")]
    [InlineData("de-DE")]
    [InlineData("ar-SA")]
    [InlineData("sv-SE")]
    public void The_culture_does_not_matter(string name)
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        byte[] invariant = GlbFile.Write(SampleCreature.Build(SampleShape.Of(11)));
        try
        {
            CultureInfo.CurrentCulture = CultureInfo.GetCultureInfo(name);
            CultureInfo.CurrentUICulture = CultureInfo.CurrentCulture;
            Assert.Equal(invariant, GlbFile.Write(SampleCreature.Build(SampleShape.Of(11))));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
            CultureInfo.CurrentUICulture = before;
        }
    }

    [Fact]
    public void No_version_path_or_date_is_in_the_file()
    {
        string text = System.Text.Encoding.Latin1.GetString(GlbFile.Write(SampleCreature.Build(SampleShape.Of(4))));
        string version = typeof(GlbWriter).Assembly.GetName().Version!.ToString(3);
        Assert.DoesNotContain(version, text, StringComparison.Ordinal);
        Assert.DoesNotContain(AppContext.BaseDirectory, text, StringComparison.OrdinalIgnoreCase);
        Assert.DoesNotContain(DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture), text, StringComparison.Ordinal);
    }
}
