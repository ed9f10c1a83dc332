using System;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Maths;

public class FastTrigonometryTests
{
    /// <summary>Two units in the last place of numbers up to 1, and twice that of what an angle in single precision misses by itself.</summary>
    private const double Hair = 2.5e-7;

    [Fact]
    public void Sine_and_cosine_are_those_of_the_angle_at_any_size()
    {
        for (int i = -40000; i <= 40000; i++)
        {
            float angle = i * 2.5e-4f;
            FastTrigonometry.SinCos(angle, out float sine, out float cosine);
            Assert.InRange(sine, Math.Sin(angle) - Hair, Math.Sin(angle) + Hair);
            Assert.InRange(cosine, Math.Cos(angle) - Hair, Math.Cos(angle) + Hair);
        }
    }

    [Fact]
    public void Small_sines_keep_their_relative_precision()
    {
        for (float angle = 0.7f; angle > 1e-30f; angle *= 0.7f)
        {
            FastTrigonometry.SinCos(angle, out float sine, out _);
            Assert.InRange(sine / Math.Sin(angle), 1 - Hair, 1 + Hair);
        }
    }

    [Fact]
    public void Turns_have_the_sine_and_cosine_of_what_is_left_of_the_last()
    {
        for (int i = -3000; i <= 3000; i++)
        {
            float turns = i / 1000f;
            FastTrigonometry.OfTurns(turns, out float sine, out float cosine);
            double angle = 2 * Math.PI * turns;
            Assert.InRange(sine, Math.Sin(angle) - 1e-6, Math.Sin(angle) + 1e-6);
            Assert.InRange(cosine, Math.Cos(angle) - 1e-6, Math.Cos(angle) + 1e-6);
        }
    }

    [Fact]
    public void Quarter_turns_are_exact()
    {
        float[] sines = { 0f, 1f, 0f, -1f };
        for (int quarter = -8; quarter <= 8; quarter++)
        {
            FastTrigonometry.OfTurns(0.25f * quarter, out float sine, out float cosine);
            Assert.Equal(sines[quarter & 3], sine);
            Assert.Equal(sines[(quarter + 1) & 3], cosine);
        }
    }

    [Fact]
    public void Angles_of_points_are_those_of_the_whole_circle()
    {
        for (int i = -3141; i <= 3141; i++)
        {
            foreach (double length in new[] { 1e-6, 1.0, 3e7 })
            {
                double angle = i * 1e-3;
                float rise = (float)(length * Math.Sin(angle));
                float run = (float)(length * Math.Cos(angle));
                double expected = Math.Atan2(rise, run);
                Assert.InRange(FastTrigonometry.Of(rise, run), expected - (2 * Hair), expected + (2 * Hair));
            }
        }
    }

    [Fact]
    public void The_point_at_the_origin_has_no_angle() => Assert.Equal(0f, FastTrigonometry.Of(0f, 0f));

    [Fact]
    public void The_angle_of_a_sine_gives_it_back_and_goes_no_farther_than_a_quarter_turn()
    {
        for (int i = -1000; i <= 1000; i++)
        {
            float sine = i / 1000f;
            Assert.InRange(Math.Sin(FastTrigonometry.OfSine(sine)), sine - Hair, sine + Hair);
        }

        Assert.Equal((float)(Math.PI / 2), FastTrigonometry.OfSine(1.5f));
        Assert.Equal((float)(-Math.PI / 2), FastTrigonometry.OfSine(-1.5f));
    }
}
