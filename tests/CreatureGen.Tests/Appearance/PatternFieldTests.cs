using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class PatternFieldTests
{
    public static TheoryData<PatternKind> Kinds() => new(Enum.GetValues<PatternKind>());

    [Theory]
    [MemberData(nameof(Kinds))]
    public void Patterns_are_symmetric_in_range_and_repeatable(PatternKind kind)
    {
        var field = new PatternField(kind, 1.1, 12, 0);
        RandomStream random = new Seed(5).Stream();
        for (int n = 0; n < 500; n++)
        {
            var p = new Vector3((float)random.Uniform(-1, 1), (float)random.Uniform(0, 2), (float)random.Uniform(-2, 2));
            float run = (float)random.Uniform(0, 4);
            float around = (float)random.Uniform(0, Math.PI);
            float value = field.At(new PatternPlace(p, run, around));
            Assert.InRange(value, 0f, 1f);
            Assert.Equal(value, field.At(new PatternPlace(new Vector3(-p.X, p.Y, p.Z), run, around)));
        }
    }

    [Theory]
    [InlineData(PatternKind.Spots, 0.03, 0.45)]
    [InlineData(PatternKind.Stripes, 0.15, 0.55)]
    [InlineData(PatternKind.Bands, 0.25, 0.6)]
    [InlineData(PatternKind.Patches, 0.2, 0.7)]
    [InlineData(PatternKind.Mottle, 0.2, 0.8)]
    [InlineData(PatternKind.Saddle, 0.2, 0.6)]
    [InlineData(PatternKind.Plain, 0.0, 0.25)]
    public void Each_pattern_covers_its_share_of_the_skin(PatternKind kind, double least, double most)
    {
        double mean = Enumerable.Range(0, 5).Average(seed => Sample(new PatternField(kind, 1, seed, 0)).Average());
        Assert.InRange(mean, least, most);
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void The_seed_chooses_among_patterns_of_one_kind(PatternKind kind)
    {
        float[] one = Sample(new PatternField(kind, 1, 1, 0));
        float[] two = Sample(new PatternField(kind, 1, 2, 0));
        Assert.True(one.Zip(two, (a, b) => Math.Abs(a - b)).Max() > 0.1f);
    }

    [Fact]
    public void A_saddle_lies_on_the_back_and_not_on_the_belly()
    {
        var field = new PatternField(PatternKind.Saddle, 1, 3, 0);
        for (int n = 0; n < 50; n++)
        {
            var p = new Vector3(0.1f, 1f, n * 0.05f);
            Assert.True(field.At(new PatternPlace(p, n * 0.05f, 0.1f)) > 0.9f);
            Assert.Equal(0f, field.At(new PatternPlace(p, n * 0.05f, 2.8f)));
        }
    }

    [Fact]
    public void Bands_count_metres_along_the_body_and_scale_with_their_frequency()
    {
        Assert.InRange(Edges(1), 3, 7);
        Assert.InRange(Edges(2) / (double)Edges(1), 1.5, 2.6);
    }

    private static int Edges(double scale)
    {
        var field = new PatternField(PatternKind.Bands, scale, 4, 0);
        int edges = 0;
        bool last = false;
        for (int n = 0; n <= 2000; n++)
        {
            bool now = field.At(new PatternPlace(new Vector3(0.2f, 1f, 0f), n * 0.001f, 1f)) > 0.5f;
            edges += now && !last ? 1 : 0;
            last = now;
        }

        return edges;
    }

    private static float[] Sample(PatternField field) => Enumerable.Range(0, 4000).Select(n =>
    {
        float z = (n % 80) * 0.025f;
        float around = MathF.PI * (n / 80) / 50f;
        return field.At(new PatternPlace(new Vector3(0.2f * MathF.Sin(around), 1f + (0.2f * MathF.Cos(around)), -z), z, around));
    }).ToArray();
}
