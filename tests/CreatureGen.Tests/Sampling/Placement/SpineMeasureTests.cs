using System;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class SpineMeasureTests
{
    private static readonly SpineMeasure Tapered = Spines.Bent(new[] { 0.2, 0.4, 0.3 }, 0.5, new[] { 1.0, 1.2, 1.4 }, 1.2);

    [Fact]
    public void Between_two_bones_the_body_is_mixed_from_both()
    {
        SpineSection section = Tapered.At(24);
        Assert.Equal(0.5, section.Along, 12);
        Assert.Equal(-0.5, section.Z, 12);
        Assert.Equal(1.1, section.Height, 12);
        Assert.Equal(0.3, section.HipWidth, 12);
        Assert.Equal(0.25, section.RingSpacing, 12);
        Assert.Equal(0.5 / Math.Sqrt(0.25 + 0.04), section.Level, 12);
    }

    [Fact]
    public void Beyond_the_ends_the_spine_goes_on_straight_with_the_last_bones_thickness()
    {
        SpineSection before = Tapered.At(21);
        Assert.Equal(-0.25, before.Along, 12);
        Assert.Equal(0.25, before.Z, 12);
        Assert.Equal(0.8, before.Height, 12);
        Assert.Equal(0.2, before.HipWidth, 12);
        SpineSection behind = Tapered.At(29);
        Assert.Equal(1.75, behind.Along, 12);
        Assert.Equal(0.3, behind.HipWidth, 12);
    }

    [Fact]
    public void The_nearest_bone_is_found_and_a_tie_goes_to_the_front()
    {
        Assert.Equal(0, Tapered.BoneAt(0));
        Assert.Equal(0, Tapered.BoneAt(24));
        Assert.Equal(1, Tapered.BoneAt(24.1));
        Assert.Equal(2, Tapered.BoneAt(54));
    }

    [Fact]
    public void Raising_moves_every_height_and_nothing_else()
    {
        SpineMeasure raised = Tapered.Raised(0.25);
        Assert.Equal(1.45, raised.BodyHeight, 12);
        Assert.Equal(1.45, raised.CentreOfMass.Y, 12);
        Assert.Equal(Tapered.CentreOfMass.Z, raised.CentreOfMass.Z);
        Assert.Equal(Tapered.BodyLength, raised.BodyLength);
        Assert.Equal(Tapered.Bones[2] with { Height = 1.65 }, raised.Bones[2]);
        Assert.Same(Tapered, Tapered.Raised(0));
    }

    [Fact]
    public void Impossible_bones_are_named_in_the_error()
    {
        var good = new SpineBone(0, 23, 0.2, 0.1, 1, 0.2, 0);
        var mass = new SagittalPoint(1, 0);
        SpineMeasure Build(SpineBone second) => new(new[] { good, second }, 1, 1, 0, mass);

        Assert.Contains("bone 1: ring is 22", Assert.Throws<ArgumentException>(() => Build(good with { Index = 1, Ring = 22 })).Message, StringComparison.Ordinal);
        Assert.Contains("bone 1: index is 0", Assert.Throws<ArgumentException>(() => Build(good)).Message, StringComparison.Ordinal);
        Assert.Contains("bone 1: width 0", Assert.Throws<ArgumentException>(() => Build(good with { Index = 1, Ring = 25, HipWidth = 0 })).Message, StringComparison.Ordinal);
        Assert.Contains("bone 1: height NaN", Assert.Throws<ArgumentException>(() => Build(good with { Index = 1, Ring = 25, Height = double.NaN })).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new SpineMeasure(new[] { good }, 1, 1, 0, mass));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SpineMeasure(new[] { good, good with { Index = 1, Ring = 25 } }, 0, 1, 0, mass));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SpineMeasure(new[] { good, good with { Index = 1, Ring = 25 } }, 1, 1, 2, mass));
    }

    [Fact]
    public void A_uniform_tube_is_surveyed_as_equal_bones_with_its_mass_in_the_middle()
    {
        double[] y = new double[BodyGrid.Rings];
        double[] z = new double[BodyGrid.Rings];
        double[] width = new double[BodyGrid.Rings];
        double[] top = new double[BodyGrid.Rings];
        double[] bottom = new double[BodyGrid.Rings];
        for (int i = 0; i < y.Length; i++)
        {
            y[i] = 0.6 + (0.03 * i);
            z[i] = -0.04 * i;
            width[i] = 0.1;
            top[i] = 0.12;
            bottom[i] = 0.13;
        }

        SpineMeasure measure = SpineSurvey.Measure(y, z, width, top, bottom);
        Assert.Equal(SpineSurvey.TorsoBones, measure.Bones.Count);
        Assert.Equal(22 * 0.05, measure.BodyLength, 12);
        Assert.Equal(measure.BodyLength, measure.SpineLength, 12);
        Assert.Equal(5, measure.CentreBone);
        Assert.Equal(0.6 + (0.03 * 33), measure.BodyHeight, 12);

        // The lower half of each section is deeper by a hundredth, and the centroid of half an ellipse is 4 / 3π of its half axis off the spine, across the slope of 3 : 4.
        double below = 4 / (3 * Math.PI) * 0.01;
        Assert.Equal((-0.04 * 27) - (0.6 * below), measure.CentreOfMass.Z, 12);
        Assert.Equal(0.6 + (0.03 * 27) - (0.8 * below), measure.CentreOfMass.Y, 12);
        foreach (SpineBone bone in measure.Bones)
        {
            Assert.Equal(0.1, bone.Length, 12);
            Assert.Equal(0.2, bone.HipWidth, 12);
            Assert.Equal(0.25, bone.Thickness, 12);
            Assert.Equal(23 + (2 * bone.Index), bone.Ring, 12);
            Assert.Equal(-0.04 * bone.Ring, bone.Z, 12);
        }

        Assert.Equal(0.05, measure.At(31).RingSpacing, 12);
        Assert.Equal(0.8, measure.At(31).Level, 12);
        Assert.Throws<ArgumentException>(() => SpineSurvey.Measure(y, z, width, top, new double[3]));
        Assert.Throws<ArgumentException>(() => SpineSurvey.Measure(y, z, width, top, bottom, 30, 30, 4));
        Assert.Throws<ArgumentOutOfRangeException>(() => SpineSurvey.Measure(y, z, width, top, bottom, 22, 44, 1));
    }
}
