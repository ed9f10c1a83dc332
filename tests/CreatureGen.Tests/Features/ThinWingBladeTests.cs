using System;
using System.Numerics;
using CreatureGen.Anatomy.Wings;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class ThinWingBladeTests
{
    [Theory]
    [InlineData(12, 14, 0.4f)]
    [InlineData(-6, 36, 0.35f)]
    [InlineData(-16, 10, 0.6f)]
    [InlineData(-36, 26, 0.6f)]
    public void The_near_one_of_spread_wings_shows_its_blade_to_who_looks_from_the_front_left_and_above(double azimuth, double elevation, float least)
    {
        Vector3 along = Direction(azimuth, elevation);
        Vector3 face = Vector3.Cross(along, ThinWingBlade.Trailing(along));
        Assert.InRange(Vector3.Dot(face, Direction(52, 14)), least, 1f);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(12, 14)]
    [InlineData(-6, 36)]
    [InlineData(2, 45)]
    public void A_spread_wing_shows_a_third_of_its_depth_from_the_front(double azimuth, double elevation)
    {
        Vector3 along = Direction(azimuth, elevation);
        Vector3 back = ThinWingBlade.Trailing(along);
        var inPicture = new Vector2(along.X, along.Y);
        var across = new Vector2(-inPicture.Y, inPicture.X);
        Assert.InRange(Math.Abs(Vector2.Dot(new Vector2(back.X, back.Y), across / across.Length())), 0.33f, 0.7f);
    }

    [Theory]
    [InlineData(-36, 26)]
    [InlineData(-48, 20)]
    [InlineData(-28, 12)]
    [InlineData(-44, 24)]
    public void A_hind_wing_that_points_back_shows_a_quarter_of_its_blade_from_the_side_and_most_from_behind(double azimuth, double elevation)
    {
        Vector3 along = Direction(azimuth, elevation);
        Vector3 face = Vector3.Cross(along, ThinWingBlade.Trailing(along));
        Assert.InRange(Math.Abs(face.X), 0.25f, 0.7f);
        Assert.InRange(Math.Abs(face.Z), 0.6f, 0.95f);
    }

    /// <summary>They fell to the midline and were slivers from the side.</summary>
    [Theory]
    [InlineData(-72, 7)]
    [InlineData(-76, 6)]
    [InlineData(-77, 5)]
    public void Wings_laid_back_are_a_roof_that_shows_two_fifths_of_its_blade_from_the_side(double azimuth, double elevation)
    {
        Vector3 along = Direction(azimuth, elevation);
        Vector3 back = ThinWingBlade.Trailing(along);
        Assert.True(back.X < 0f && back.Y > 0f, FormattableString.Invariant($"the rear edge goes {back}"));
        Assert.InRange(Math.Abs(Vector3.Cross(along, back).X), 0.4f, 0.7f);
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(-36, 26)]
    [InlineData(-85, 2)]
    public void The_blade_is_square_to_its_axis_and_goes_back(double azimuth, double elevation)
    {
        Vector3 along = Direction(azimuth, elevation);
        Vector3 back = ThinWingBlade.Trailing(along);
        Assert.Equal(1f, back.Length(), 1e-5f);
        Assert.Equal(0f, Vector3.Dot(along, back), 1e-5f);
        Assert.True(Vector3.Dot(back, new Vector3((float)Math.Sin(azimuth * Math.PI / 180), 0f, -(float)Math.Cos(azimuth * Math.PI / 180))) > 0f);
    }

    [Fact]
    public void A_level_wing_is_raised_at_rest_by_what_its_edge_rises_more_than_in_flight()
    {
        Assert.Equal(Math.Atan(0.85) - Math.Atan(0.22), ThinWingBlade.RestIncidence(Vector3.UnitX), 1e-6);
    }

    [Fact]
    public void Wings_laid_back_lie_at_rest_as_they_fly()
    {
        Assert.Equal(0, ThinWingBlade.RestIncidence(Direction(-84, 3)), 1e-6);
    }

    private static Vector3 Direction(double azimuth, double elevation)
    {
        (double a, double e) = (azimuth * Math.PI / 180, elevation * Math.PI / 180);
        return new Vector3((float)(Math.Cos(a) * Math.Cos(e)), (float)Math.Sin(e), (float)(Math.Sin(a) * Math.Cos(e)));
    }
}
