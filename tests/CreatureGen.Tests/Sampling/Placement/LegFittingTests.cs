using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Sampling.Placement;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class LegFittingTests
{
    private static readonly SpineMeasure Body = Spines.Level(new[] { 0.4, 0.4, 0.4, 0.4, 0.4, 0.4 }, 0.2, 0.9, thickness: 0.5);

    public static TheoryData<LimbArchetype> StandingArchetypes { get; } = new(
        LimbArchetype.DigitigradeHind,
        LimbArchetype.DigitigradeFore,
        LimbArchetype.UnguligradeHind,
        LimbArchetype.UnguligradeFore,
        LimbArchetype.PlantigradeHind,
        LimbArchetype.PlantigradeFore,
        LimbArchetype.Column,
        LimbArchetype.Sprawl,
        LimbArchetype.Theropod,
        LimbArchetype.Insect);

    [Theory]
    [InlineData(8, 0.9)]
    [InlineData(0, 1.15)]
    [InlineData(16, 0.65)]
    [InlineData(12, 0.9 - (0.25 * 0.70710678118654752))]
    public void The_length_of_a_leg_is_the_distance_from_its_attachment_point_to_the_ground(double segment, double length)
    {
        var site = new LimbSocket(29, segment, LimbArchetype.Column, 0.5, 0, 0, SocketBounds.Limb);
        LegPlacement leg = LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Nominal);
        Assert.Equal(length, leg.Length, 12);
        Assert.Equal(0, leg.TipHeight);
    }

    [Theory]
    [MemberData(nameof(StandingArchetypes))]
    public void The_root_keeps_within_the_girths_of_its_built_form(LimbArchetype archetype)
    {
        LegBuild build = LegKinds.Of(archetype).Build;
        foreach (double girth in new[] { 0.01, 0.3, 0.6, 3 })
        {
            var site = new LimbSocket(29, 10, archetype, girth, 0.3, 0, SocketBounds.Limb);
            LegPlacement leg = LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Nominal);
            double unit = build.Posture == LimbPosture.Splayed ? leg.Reach : leg.Length;
            Assert.InRange(leg.RootRadius, (build.MinGirth * unit) - 1e-12, (build.GreatestGirth * unit) + 1e-12);
            Assert.Equal(build.MinGirth * unit, LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Min).RootRadius, 12);
        }
    }

    [Theory]
    [MemberData(nameof(StandingArchetypes))]
    public void Left_and_right_feet_never_touch(LimbArchetype archetype)
    {
        foreach (double segment in new[] { 8.0, 10.6, 15.9 })
        {
            var site = new LimbSocket(29, segment, archetype, 0.6, 0.3, 0.3, SocketBounds.Limb);
            FootContact foot = LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Nominal).Foot;
            Assert.True(foot.X - foot.HalfWidth >= LegFitting.MidlineGap - 1e-12);
        }
    }

    [Fact]
    public void A_leg_under_the_body_swings_with_its_length_and_a_splayed_one_with_its_reach()
    {
        var under = new LimbSocket(29, 8, LimbArchetype.DigitigradeHind, 0.5, 0, 0, SocketBounds.Limb);
        Assert.Equal(0.9 * Math.Sin(35 * Math.PI / 180), LegFitting.Stand(Body, under, LegSize.Nominal, LegGirth.Nominal).Swing, 9);
        var splayed = new LimbSocket(29, 8, LimbArchetype.Sprawl, 0.5, 0.25, 0, SocketBounds.Limb);
        LegPlacement leg = LegFitting.Stand(Body, splayed, LegSize.Nominal with { Reach = 1.2 }, LegGirth.Nominal);
        Assert.Equal(0.25 * 1.2 * 1.2, leg.Reach, 12);
        Assert.Equal(1.12 * leg.Reach * 0.5, leg.Swing, 9);
    }

    [Fact]
    public void A_splayed_leg_turned_to_the_front_stands_further_in_front()
    {
        var site = new LimbSocket(29, 10, LimbArchetype.Insect, 0.3, 0.3, 0.5, SocketBounds.Insect);
        LegPlacement ahead = LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Nominal);
        LegPlacement behind = LegFitting.Stand(Body, site with { Azimuth = -0.5 }, LegSize.Nominal, LegGirth.Nominal);
        Assert.True(ahead.Foot.Z > ahead.RootZ + 0.1);
        Assert.Equal(ahead.Foot.Z - ahead.RootZ, behind.RootZ - behind.Foot.Z, 9);
        Assert.Equal(ahead.Foot.X, behind.Foot.X, 9);
    }

    [Fact]
    public void A_hanging_leg_has_the_length_asked_for_and_ends_in_the_air()
    {
        var site = new LimbSocket(29, 8, LimbArchetype.Theropod, 0.5, 0, 0, SocketBounds.Limb);
        LegPlacement leg = LegFitting.Hang(Body, site, LegSize.Nominal, 0.4, 0.5);
        Assert.Equal(0.4, leg.Length, 12);
        Assert.Equal(0.5, leg.TipHeight, 12);
        Assert.Equal(site, leg.Site);
        Assert.True(leg.RootRadius <= 0.5 * LegFitting.Hang(Body, site, LegSize.Nominal, 0.4, 1).RootRadius + 1e-12);
    }

    [Fact]
    public void A_shifted_foot_leans_the_leg()
    {
        var site = new LimbSocket(29, 8, LimbArchetype.Theropod, 0.5, 0, 0, SocketBounds.Limb);
        LegPlacement leg = LegFitting.Stand(Body, site, LegSize.Nominal, LegGirth.Nominal);
        LegPlacement corrected = leg.Corrected(0.09, 1.2);
        Assert.Equal(0.1, corrected.Shear, 12);
        Assert.Equal(leg.Foot.Z + 0.09, corrected.Foot.Z, 12);
        Assert.Equal(leg.Foot.Toe * 1.2, corrected.Foot.Toe, 12);
    }

    [Fact]
    public void Sizes_that_are_not_positive_are_errors()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => LegFitting.Check(LegSize.Nominal with { Girth = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => LegFitting.Check(LegSize.Nominal with { Reach = double.NaN }));
        Assert.Throws<ArgumentOutOfRangeException>(() => LegFitting.Check(LegSize.Nominal with { Foot = double.PositiveInfinity }));
        Assert.Throws<ArgumentOutOfRangeException>(() => LegFitting.Check(LegSize.Nominal with { Toes = -1 }));
    }
}
