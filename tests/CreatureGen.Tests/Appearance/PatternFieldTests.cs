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
    [InlineData(PatternKind.Rosettes, 0.25, 0.6)]
    [InlineData(PatternKind.Giraffe, 0.4, 0.75)]
    [InlineData(PatternKind.Turing, 0.4, 0.6)]
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

    [Theory]
    [InlineData(PatternKind.Rosettes, 0.15f)]
    [InlineData(PatternKind.Giraffe, 0.15f)]
    [InlineData(PatternKind.Turing, 0.15f)]
    public void New_kinds_are_continuous_and_cross_the_midline_without_a_seam(PatternKind kind, float most)
    {
        var field = new PatternField(kind, 1, 21, 0);
        for (int n = 0; n < 4000; n++)
        {
            float along = n * 0.0005f;
            float here = At(0f, along);
            Assert.InRange(Math.Abs(At(0.0005f, along) - here), 0f, most);
            Assert.Equal(At(-0.0005f, along), At(0.0005f, along));
            Assert.InRange(Math.Abs(At(0f, along + 0.0005f) - here), 0f, most);
        }

        float At(float x, float z) => field.At(new PatternPlace(new Vector3(x, 1.2f, -z), z, 0f));
    }

    [Fact]
    public void A_seam_between_plates_is_bare_and_the_middle_of_a_plate_is_full()
    {
        float[] shares = Sample(new PatternField(PatternKind.Giraffe, 1, 2, 0));
        Assert.InRange(shares.Count(share => share == 0f) / (double)shares.Length, 0.1, 0.5);
        Assert.InRange(shares.Count(share => share == 1f) / (double)shares.Length, 0.3, 0.8);
    }

    [Fact]
    public void A_rosette_has_a_half_shaded_middle_within_a_full_ring()
    {
        float[] shares = Sample(new PatternField(PatternKind.Rosettes, 1, 2, 0));
        Assert.InRange(shares.Count(share => share is > 0.33f and < 0.4f) / (double)shares.Length, 0.1, 0.5);
        Assert.InRange(shares.Count(share => share > 0.95f) / (double)shares.Length, 0.1, 0.5);
    }

    [Fact]
    public void A_labyrinth_has_one_width_in_every_direction_and_scales_with_its_frequency()
    {
        foreach (Vector3 direction in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, Vector3.Normalize(Vector3.One) })
        {
            double crossings = Enumerable.Range(0, 8).Average(seed => Crossings(new RandomWaves(10, seed), direction));

            // Rice's formula: a random field of one wave number k in space has k/(π√3) zeros per unit of length, 11.5 of 10 waves.
            Assert.InRange(crossings, 0.85 * 11.547, 1.15 * 11.547);
            double twice = Enumerable.Range(0, 8).Average(seed => Crossings(new RandomWaves(20, seed), direction));
            Assert.InRange(twice / crossings, 1.8, 2.2);
        }
    }

    [Fact]
    public void Random_waves_have_the_mean_0_and_the_deviation_1()
    {
        RandomStream random = new Seed(9).Stream();
        for (int salt = 0; salt < 10; salt++)
        {
            var waves = new RandomWaves(3, salt);
            double[] values = Enumerable.Range(0, 20000).Select(n => (double)waves.At(new Vector3((float)random.Uniform(-20, 20), (float)random.Uniform(-20, 20), (float)random.Uniform(-20, 20)))).ToArray();
            Assert.Equal(0, values.Average(), 0.04);
            Assert.Equal(1, Math.Sqrt(values.Average(v => v * v)), 0.04);
        }
    }

    private static double Crossings(RandomWaves waves, Vector3 direction)
    {
        const int Steps = 20000;
        const float Length = 20f;
        return Enumerable.Range(0, Steps).Count(n => At(n) < 0f != At(n + 1) < 0f) / (double)Length;

        float At(int n) => waves.At(new Vector3(0.3f, 0.2f, 0.1f) + (direction * (Length * n / Steps)));
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
