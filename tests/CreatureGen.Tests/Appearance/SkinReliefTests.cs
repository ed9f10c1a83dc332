using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance.Textures;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class SkinReliefTests
{
    // Rows follow each other at 1/1.15 of the size of a scale.
    private const float Row = 1f / 1.15f;

    [Fact]
    public void The_rounded_end_of_a_scale_lies_over_the_row_behind_it()
    {
        var scales = new SkinRelief(SkinCover.Scales, 1f, 3);
        float middle = scales.At(new Vector2(0.5f, 1.2f * Row));
        float between = scales.At(new Vector2(0f, 1.2f * Row));

        // In the middle the end of the scale in front, between two of them the low beginning of the one behind.
        Assert.Equal(0.45f + (0.5f * 0.8f), middle, 1e-4f);
        Assert.Equal(0.45f + (0.5f * 0.2f / 1.5f), between, 1e-4f);
    }

    [Fact]
    public void A_scale_ends_after_one_and_a_half_rows()
    {
        var scales = new SkinRelief(SkinCover.Scales, 1f, 3);
        float before = scales.At(new Vector2(0.5f, 1.4f * Row));
        float after = scales.At(new Vector2(0.5f, 1.55f * Row));
        Assert.True(before > after + 0.2f, $"{before} before the end, {after} behind it");
    }

    /// <summary>Of slopes in all directions alike a third would lie within 15 degrees of rows and columns.</summary>
    [Fact]
    public void Folds_of_naked_skin_do_not_run_along_rows_and_columns()
    {
        const float Step = 0.01f;
        var skin = new SkinRelief(SkinCover.Wrinkles, 1f, 5);
        int steep = 0;
        int aligned = 0;
        for (int i = 0; i < 40000; i++)
        {
            var at = new Vector2(i % 200 * 0.0713f, i / 200 * 0.0691f);
            float across = Math.Abs(skin.At(at + new Vector2(Step, 0)) - skin.At(at - new Vector2(Step, 0)));
            float along = Math.Abs(skin.At(at + new Vector2(0, Step)) - skin.At(at - new Vector2(0, Step)));
            if (Math.Max(across, along) > 0.025f)
            {
                steep++;
                aligned += Math.Min(across, along) < 0.268f * Math.Max(across, along) ? 1 : 0;
            }
        }

        Assert.True(steep > 4000);
        Assert.InRange((double)aligned / steep, 0, 0.4);
    }

    [Theory]
    [InlineData((int)SkinCover.Wrinkles)]
    [InlineData((int)SkinCover.Fur)]
    [InlineData((int)SkinCover.Scales)]
    [InlineData((int)SkinCover.Feathers)]
    [InlineData((int)SkinCover.Plates)]
    public void Every_cover_stays_within_its_amplitude_and_uses_most_of_it(int cover)
    {
        var relief = new SkinRelief((SkinCover)cover, 0.04f, 5);
        float least = float.MaxValue;
        float most = float.MinValue;
        for (int i = 0; i < 20000; i++)
        {
            float height = relief.At(new Vector2((i % 141) * 0.0031f, (i / 141) * 0.0029f));
            least = Math.Min(least, height);
            most = Math.Max(most, height);
        }

        Assert.InRange(least, 0f, 0.4f);
        Assert.InRange(most, 0.75f, 1f);
    }

    /// <summary>Scattered plates were stones in a wall, and a round abdomen a rough lump.</summary>
    [Fact]
    public void Plates_of_insects_are_rings_around_body_and_limbs()
    {
        var plates = new SkinRelief(SkinCover.Plates, 1f, 3);
        for (int i = 0; i < 40; i++)
        {
            float around = 0.37f * i;
            Assert.True(Lowest(along => plates.At(new Vector2(around, 5f + along))) < 0.1f);
            Assert.True(Lowest(along => plates.OnBody(new Vector2(around, 0), 43 + (2 * (along - 0.5f)), 3)) < 0.1f);
            Assert.True(plates.OnBody(new Vector2(around, 0), 45, 3) > 0.7f);
            Assert.True(plates.OnBody(new Vector2(around, 0), 45, 25) < 0.1f == plates.OnBody(new Vector2(around, 0), 45, 7) < 0.1f, "both flanks are alike");
        }

        static float Lowest(Func<float, float> height)
        {
            float lowest = 1;
            for (int k = 0; k < 100; k++)
            {
                lowest = Math.Min(lowest, height(0.01f * k));
            }

            return lowest;
        }
    }

    [Fact]
    public void A_plated_head_is_one_capsule_and_plated_flanks_have_a_seam()
    {
        var plates = new SkinRelief(SkinCover.Plates, 0.09f, 3);
        for (int i = 0; i < 100; i++)
        {
            Assert.Equal(plates.OnBody(Vector2.Zero, 9, 3), plates.OnBody(new Vector2(0.013f * i, 0), 0.14f * i, 0.16f * i));
        }

        Assert.True(plates.OnBody(Vector2.Zero, 44.5f, 7.2f) < 0.05f && plates.OnBody(Vector2.Zero, 44.5f, 5.5f) > 0.5f);
    }

    /// <summary>As broad as those of insects they were parts of a machine.</summary>
    [Theory]
    [InlineData(24832105, RequestedKind.Walking, true)]
    [InlineData(24815011, RequestedKind.Walking, true)]
    [InlineData(24832005, RequestedKind.Walking, false)]
    public void Plates_are_narrower_on_bodies_that_are_no_insects(ulong seed, RequestedKind kind, bool narrow)
    {
        SkinRelief relief = CoatSubjects.ReliefOf(BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind }));
        Assert.True(relief.IsPlated);
        float between = relief.OnBody(Vector2.Zero, 41.5f, 3);
        Assert.True(narrow ? between < 0.35f : between > 0.6f, $"{seed}: {between} between the seams of an insect");
    }

    [Theory]
    [InlineData((int)SkinCover.Feathers)]
    [InlineData((int)SkinCover.Scales)]
    public void Feathers_and_scales_are_finer_on_limbs(int cover)
    {
        var relief = new SkinRelief((SkinCover)cover, 0.04f, 3);
        Assert.True(Edges(relief.OnLimb) > 1.3 * Edges(place => relief.OnBody(place, 30, 5)));

        static int Edges(Func<Vector2, float> height)
        {
            int edges = 0;
            bool high = false;
            for (int k = 0; k < 8000; k++)
            {
                float here = height(new Vector2(0.003f, 0.0005f * k));
                edges += high && here < 0.6f ? 1 : 0;
                high = here > 0.75f || (high && here >= 0.6f);
            }

            return edges;
        }
    }
}
