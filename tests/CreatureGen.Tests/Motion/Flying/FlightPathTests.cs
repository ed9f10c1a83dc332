using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Flying;

/// <summary>The way of fliers through the air.</summary>
public sealed class FlightPathTests
{
    private static readonly (float Seconds, MotionInput Input)[] script =
    [
        (0.5f, new MotionInput(0.6f)),
        (2f, new MotionInput(4f, 0.9f, ClimbRate: 0.5f, Medium: MotionMedium.Air)),
        (2f, new MotionInput(2f, -1.4f, ClimbRate: -0.4f, Medium: MotionMedium.Air)),
        (2.5f, new MotionInput(0.5f, 0.3f, ClimbRate: -2f)),
        (1.5f, new MotionInput(5f, Medium: MotionMedium.Air)),
        (8f, new MotionInput(0f, ClimbRate: -2f)),
    ];

    /// <summary>Thousandths of a leg after a hundred legs of way with two leaps and two landings, where single updates of 1/30 s are ten legs long for the smallest.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(10900003)]
    [InlineData(10900009)]
    [InlineData(10900012)]
    [InlineData(10900022)]
    public void It_comes_down_at_the_same_place_at_every_frame_rate(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        CreatureAnimator finest = At(480, profile);
        Assert.True(finest.StandsOnFeet);
        Assert.True(finest.Root.Position.Length() > 3f * profile.LegLength);
        foreach (int rate in new[] { 30, 60, 144 })
        {
            CreatureAnimator animator = At(rate, profile);
            float apart = Vector3.Distance(finest.Root.Position, animator.Root.Position) / profile.LegLength;
            Assert.True(apart < 0.005f, FormattableString.Invariant($"{seed} at {rate} Hz: {apart} legs"));
        }
    }

    /// <summary>It went up and down about its lowest height, four times a second by a thirtieth of a leg, and where it was in that at the next command differed with the rate.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(10900003)]
    [InlineData(10900009)]
    [InlineData(10900012)]
    [InlineData(10900022)]
    [InlineData(24800271)]
    public void Told_to_sink_in_the_air_it_comes_to_its_lowest_height_and_stays_there(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        var animator = new CreatureAnimator(profile);
        Fly(3f, 0.5f, null);
        Fly(10f, -0.5f, null);
        var heights = new List<float>();
        Fly(2f, -0.5f, heights);
        Assert.InRange(heights.Max(), 0.5f, 1.25f);
        Assert.InRange(heights.Max() - heights.Min(), 0f, 0.001f);

        void Fly(float seconds, float climb, List<float>? seen)
        {
            for (int i = 0; i < seconds * 60f; i++)
            {
                animator.Update(1f / 60f, new MotionInput(1f, ClimbRate: climb, Medium: MotionMedium.Air), FlatGround.Level);
                seen?.Add(animator.Root.Position.Y / profile.LegLength);
            }
        }
    }

    [Fact]
    public void What_happens_within_an_update_is_told_as_long_ago_as_it_was()
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(1, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        List<double> fine = Times(480);
        List<double> coarse = Times(10);
        Assert.Equal(fine.Count, coarse.Count);
        Assert.NotEmpty(fine);
        for (int i = 0; i < fine.Count; i++)
        {
            Assert.Equal(fine[i], coarse[i], 0.006);
        }

        List<double> Times(int rate)
        {
            var animator = new CreatureAnimator(profile);
            var times = new List<double>();
            for (int i = 1; i <= 3 * rate; i++)
            {
                animator.Update(1f / rate, new MotionInput(3f, Medium: MotionMedium.Air), FlatGround.Level);
                foreach (MotionEvent told in animator.Events)
                {
                    if (told.Kind == MotionEventKind.FootUp)
                    {
                        times.Add(((double)i / rate) - told.SecondsAgo);
                    }
                }
            }

            return times;
        }
    }

    private static CreatureAnimator At(int rate, MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile);
        foreach ((float seconds, MotionInput input) in script)
        {
            for (int i = 0; i < (int)Math.Round(seconds * rate); i++)
            {
                animator.Update(1f / rate, input, FlatGround.Level);
            }
        }

        return animator;
    }
}
