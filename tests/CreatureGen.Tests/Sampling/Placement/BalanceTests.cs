using System;
using System.Collections.Generic;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class BalanceTests
{
    private static readonly FootContact Foot = new(0.2, 0, 0.05, 0.1, 0.3);
    private static readonly BalanceLimits Stiff = new(0, 0, new SagittalPoint(1, 0), 0, 1);

    [Theory]
    [InlineData(0.1, 0.5)]
    [InlineData(0.0, 0.25)]
    [InlineData(-0.1, 0)]
    [InlineData(0.3, 0)]
    [InlineData(0.5, -0.5)]
    [InlineData(-0.2, -0.25)]
    public void One_pair_stands_on_the_length_of_its_soles(double z, double margin) =>
        Assert.Equal(margin, Balance.Margin(new[] { Foot }, new SagittalPoint(1, z)), 12);

    [Fact]
    public void Two_pairs_stand_on_all_the_ground_between_them()
    {
        var feet = new[] { new FootContact(0.2, 1, 0.05, 0.1, 0.1), new FootContact(0.2, 0, 0.05, 0.1, 0.1) };
        Assert.Equal(0.5, Balance.Margin(feet, new SagittalPoint(1, 0.5)), 12);
        Assert.Equal(0.2 / 1.2, Balance.Margin(feet, new SagittalPoint(1, 0.9)), 12);
        Assert.Equal(0, Balance.Margin(feet, new SagittalPoint(1, 1.1)), 12);
    }

    [Fact]
    public void A_pair_within_the_hull_of_the_others_changes_nothing()
    {
        var outer = new List<FootContact> { new(0.3, 1, 0.05, 0.1, 0.1), new(0.3, -1, 0.05, 0.1, 0.1) };
        double before = Balance.Margin(outer, new SagittalPoint(1, 0.4));
        outer.Add(new FootContact(0.2, 0, 0.05, 0.1, 0.1));
        Assert.Equal(before, Balance.Margin(outer, new SagittalPoint(1, 0.4)), 12);
    }

    [Fact]
    public void The_hull_of_a_narrow_and_a_wide_pair_is_a_trapezium()
    {
        var feet = new[] { new FootContact(0.05, 1, 0.05, 0, 0.1), new FootContact(0.35, 0, 0.05, 0.1, 0) };
        IReadOnlyList<(double X, double Z)> corners = new SupportHull(feet).Corners;
        Assert.Equal(6, corners.Count);
        foreach ((double x, double z) in corners)
        {
            Assert.Contains((-x, z), corners);
        }

        Assert.DoesNotContain((0.0, 1.1), corners);
    }

    [Fact]
    public void The_margin_agrees_with_a_naive_hull_over_random_feet()
    {
        var stream = new RandomStream(11);
        for (int n = 0; n < 500; n++)
        {
            var feet = new List<FootContact>();
            int pairs = stream.Integer(1, 5);
            for (int i = 0; i < pairs; i++)
            {
                feet.Add(new FootContact(stream.Uniform(0, 0.5), stream.Uniform(-1, 1), stream.Uniform(0.01, 0.1), stream.Uniform(0, 0.1), stream.Uniform(0.01, 0.3)));
            }

            double z = stream.Uniform(-1.5, 1.5);
            Assert.Equal(NaiveMargin(feet, z), Balance.Margin(feet, new SagittalPoint(1, z)), 9);
        }
    }

    [Fact]
    public void A_balanced_creature_is_left_alone()
    {
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, new SagittalPoint(1, -0.07), Stiff);
        Assert.Equal(BalanceRemedy.None, correction.Remedy);
        Assert.Equal(0.075, correction.Margin, 12);
        Assert.Equal(0, correction.Shift);
    }

    [Fact]
    public void The_feet_are_set_forward_by_the_least_that_restores_the_margin()
    {
        // The hull runs from −0.1 to 0.3; 6 % of 0.4 inside its front edge is 0.276.
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, new SagittalPoint(1, 0.5), Stiff with { ForemostShift = 0.4 });
        Assert.Equal(BalanceRemedy.ShiftFeet, correction.Remedy);
        Assert.Equal(0.5 - 0.276, correction.Shift, 12);
        Assert.Equal(Balance.MinMargin + Balance.Reserve, correction.Margin, 9);
    }

    [Fact]
    public void The_feet_are_set_back_under_a_heavy_tail()
    {
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, new SagittalPoint(1, -0.3), Stiff with { RearmostShift = -0.4 });
        Assert.Equal(BalanceRemedy.ShiftFeet, correction.Remedy);
        Assert.Equal(-0.3 + 0.076, correction.Shift, 12);
    }

    [Fact]
    public void The_torso_is_pitched_when_the_feet_may_not_go_far_enough()
    {
        var pivot = new SagittalPoint(1, 0);
        var mass = new SagittalPoint(1.2, 0.5);
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, mass, new BalanceLimits(-0.1, 0.1, pivot, 0.6, 1));
        Assert.Equal(BalanceRemedy.PitchTorso, correction.Remedy);
        Assert.Equal(0.1, correction.Shift);
        Assert.InRange(correction.Pitch, 0.05, 0.6);
        SagittalPoint pitched = Balance.Pitched(mass, pivot, correction.Pitch);
        Assert.Equal(0.376, pitched.Z, 9);
        Assert.Equal(Balance.MinMargin + Balance.Reserve, Balance.Margin(new[] { Foot.Shifted(0.1) }, pitched), 9);
        Assert.Equal(Balance.MinMargin + Balance.Reserve, correction.Margin, 9);
    }

    [Fact]
    public void Pitching_up_raises_what_lies_ahead_and_keeps_its_distance()
    {
        SagittalPoint pitched = Balance.Pitched(new SagittalPoint(1, 0.5), new SagittalPoint(1, 0), Math.PI / 6);
        Assert.Equal(1.25, pitched.Y, 9);
        Assert.Equal(0.5 * Math.Sqrt(3) / 2, pitched.Z, 9);
    }

    [Fact]
    public void Feet_grow_when_shift_and_pitch_are_not_enough()
    {
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, new SagittalPoint(1, 0.32), Stiff with { MaximumFootGrowth = 1.6 });
        Assert.Equal(BalanceRemedy.GrowFeet, correction.Remedy);
        Assert.InRange(correction.FootGrowth, 1.05, 1.6);
        Assert.True(Balance.Margin(new[] { Foot.Grown(correction.FootGrowth) }, new SagittalPoint(1, 0.32)) >= Balance.MinMargin);
        Assert.False(Balance.Margin(new[] { Foot.Grown(correction.FootGrowth - 0.05) }, new SagittalPoint(1, 0.32)) >= Balance.MinMargin + Balance.Reserve);
    }

    [Theory]
    [InlineData(3.0, 1)]
    [InlineData(-3.0, -1)]
    public void What_cannot_be_corrected_demands_a_pair_or_a_tail_and_says_on_which_side(double z, int side)
    {
        BalanceCorrection correction = Balance.Correct(new[] { Foot }, new SagittalPoint(1, z), new BalanceLimits(-0.1, 0.1, new SagittalPoint(1, 0), 0.1, 1.6));
        Assert.Equal(BalanceRemedy.AddPairOrTail, correction.Remedy);
        Assert.Equal(side, Math.Sign(correction.Overhang));
        Assert.True(correction.Margin < Balance.MinMargin);
    }

    [Fact]
    public void No_feet_and_no_soles_are_errors()
    {
        Assert.Throws<ArgumentException>(() => Balance.Margin(Array.Empty<FootContact>(), new SagittalPoint(1, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FootContact(0, 0, 0, 0.1, 0.1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FootContact(0, 0, 0.1, 0, 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new FootContact(double.NaN, 0, 0.1, 0.1, 0));
    }

    [Fact]
    public void Every_correction_does_what_it_says()
    {
        var stream = new RandomStream(3);
        for (int n = 0; n < 3000; n++)
        {
            var feet = new List<FootContact>();
            int pairs = stream.Integer(1, 4);
            for (int i = 0; i < pairs; i++)
            {
                feet.Add(new FootContact(stream.Uniform(0.05, 0.5), stream.Uniform(-0.5, 0.5), stream.Uniform(0.01, 0.1), stream.Uniform(0, 0.1), stream.Uniform(0.01, 0.3)));
            }

            var mass = new SagittalPoint(stream.Uniform(0.2, 2), stream.Uniform(-1.5, 1.5));
            var limits = new BalanceLimits(-stream.Uniform(0, 0.5), stream.Uniform(0, 0.5), new SagittalPoint(stream.Uniform(0.2, 1.5), stream.Uniform(-0.5, 0.5)), stream.Uniform(0, 0.5), stream.Uniform(1, 2));
            BalanceCorrection correction = Balance.Correct(feet, mass, limits);
            Assert.InRange(correction.Shift, limits.RearmostShift, limits.ForemostShift);
            Assert.InRange(correction.Pitch, -limits.MaximumPitch, limits.MaximumPitch);
            Assert.InRange(correction.FootGrowth, 1, limits.MaximumFootGrowth);
            var corrected = new List<FootContact>();
            foreach (FootContact foot in feet)
            {
                corrected.Add(foot.Grown(correction.FootGrowth).Shifted(correction.Shift));
            }

            double margin = Balance.Margin(corrected, Balance.Pitched(mass, limits.Pivot, correction.Pitch));
            Assert.Equal(margin, correction.Margin, 9);
            Assert.Equal(correction.Remedy == BalanceRemedy.AddPairOrTail, margin < Balance.MinMargin - 1e-9);
        }
    }

    /// <summary>An edge of the hull is any line through two points that has all others on one side.</summary>
    private static double NaiveMargin(List<FootContact> feet, double z)
    {
        var points = new List<(double X, double Z)>();
        foreach (FootContact f in feet)
        {
            foreach (double x in new[] { f.X - f.HalfWidth, f.X + f.HalfWidth, -f.X - f.HalfWidth, -f.X + f.HalfWidth })
            {
                points.Add((x, f.Z - f.Heel));
                points.Add((x, f.Z + f.Toe));
            }
        }

        double margin = double.MaxValue;
        foreach ((double ax, double az) in points)
        {
            foreach ((double bx, double bz) in points)
            {
                double length = Math.Sqrt(((bx - ax) * (bx - ax)) + ((bz - az) * (bz - az)));
                if (length < 1e-9)
                {
                    continue;
                }

                double least = double.MaxValue;
                double most = -double.MaxValue;
                foreach ((double x, double pz) in points)
                {
                    double d = (((bx - ax) * (pz - az)) - ((bz - az) * (x - ax))) / length;
                    least = Math.Min(least, d);
                    most = Math.Max(most, d);
                }

                if (least > -1e-12)
                {
                    double own = (((bx - ax) * (z - az)) + ((bz - az) * ax)) / length;
                    margin = Math.Min(margin, own / most);
                }
            }
        }

        return margin;
    }
}
