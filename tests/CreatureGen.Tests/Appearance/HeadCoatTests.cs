using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using Xunit;
using static CreatureGen.Tests.Appearance.StraightSkin;

namespace CreatureGen.Tests.Appearance;

public sealed class HeadCoatTests
{
    /// <summary>Least ratio of two luminances by which one is told from the other at the size of a creature on a sheet.</summary>
    private const float Told = 1.6f;

    private static readonly CoatBlueprint black = new(
        new(0.32, 0.04, 1.1), new(0.22, 0.04, 1.0), new(0.44, 0.03, 1.2), new(0.22, 0.04, 1.0), new(0.26, 0.04, 0.9), new(0.65, 0.15, 4.2),
        new(0.25, 0.02, 1), new(0.6, 0.03, 1.3), new(0.27, 0.02, 1), new(0.45, 0.12, 0.35), new(0.6, 0.11, 0.25), new(0.7, 0.14, 1.6), PatternKind.Plain, 1, 0.85, 7);

    private static readonly Vector3 front = new(0.02f, 1.02f, 1.2f);

    [Fact]
    public void Snout_lips_and_the_ring_of_the_eye_are_seen_in_a_dark_face()
    {
        foreach (SnoutKind snout in new[] { SnoutKind.Leather, SnoutKind.Bare })
        {
            CoatSubject subject = Subject(snout);
            var painter = new CoatPainter(black, subject);
            float coat = Luminance(painter.At(Address(SurfaceRegion.Body, 20, 6), new Vector3(0.2f, 1.1f, 0.4f), Vector3.UnitX));
            Assert.True(Luminance(painter.At(Address(SurfaceRegion.Body, 3, 6), front, Vector3.UnitZ)) > Told * coat, FormattableString.Invariant($"{snout}: snout"));
            Assert.True(Luminance(painter.At(Address(SurfaceRegion.Lip, 5, 10), front, Vector3.UnitX)) > Told * coat, FormattableString.Invariant($"{snout}: lips"));
            Assert.True(Luminance(painter.At(Address(SurfaceRegion.Body, 10, 6), subject.EyeCentre, Vector3.UnitX)) > Told * coat, FormattableString.Invariant($"{snout}: ring"));
        }
    }

    [Fact]
    public void The_beak_of_a_dark_bird_is_seen()
    {
        var painter = new CoatPainter(black, Subject(SnoutKind.Beak));
        float coat = Luminance(painter.At(Address(SurfaceRegion.Body, 20, 6), new Vector3(0.2f, 1.1f, 0.4f), Vector3.UnitX));
        Assert.True(Luminance(painter.At(Address(SurfaceRegion.Body, 2, 6), front, Vector3.UnitZ)) > Told * coat);
    }

    [Fact]
    public void A_face_of_a_coat_that_is_not_dark_keeps_its_dark_lips_and_its_beak()
    {
        CoatBlueprint brown = black with { Base = black.Base with { Lightness = 0.5 }, Back = black.Back with { Lightness = 0.4 } };
        var lips = new CoatPainter(brown, Subject(SnoutKind.Bare));
        Assert.True(Luminance(lips.At(Address(SurfaceRegion.Lip, 5, 10), front, Vector3.UnitX)) < Luminance(lips.At(Address(SurfaceRegion.Body, 5, 10), front + new Vector3(0f, 0.02f, 0f), Vector3.UnitX)) / Told);
        Vector3 beak = new CoatPainter(brown, Subject(SnoutKind.Beak)).At(Address(SurfaceRegion.Body, 2, 6), front, Vector3.UnitZ);
        Assert.True(Luminance(beak) < 1.1f * Luminance(OklchColour.ToLinearRgb(brown.Muzzle)));
    }

    private static float Luminance(Vector3 colour) => (0.2126f * colour.X) + (0.7152f * colour.Y) + (0.0722f * colour.Z);

    private static CoatSubject Subject(SnoutKind snout)
    {
        CoatSubject subject = StraightSkin.Subject();
        subject.Snout = snout;
        Vector3[] lip = { front + new Vector3(0.1f, 0f, -0.2f), front, front - new Vector3(front.X, 0f, 0f) };
        subject.Lips = snout == SnoutKind.Beak ? null : new MouthLine(lip, lip, 7, 0.05f);
        subject.EyeCentre = new Vector3(0.2f, 1.1f, 0.8f);
        subject.EyeRadius = 0.03f;
        return subject;
    }
}
