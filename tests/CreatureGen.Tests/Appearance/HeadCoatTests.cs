using System;
using System.Linq;
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
    public void A_bare_snout_has_a_dark_tip_between_its_nostrils()
    {
        CoatBlueprint brown = black with { Base = black.Base with { Lightness = 0.6 }, Back = black.Back with { Lightness = 0.5 }, Belly = black.Belly with { Lightness = 0.8 } };
        CoatSubject subject = Subject(SnoutKind.Bare);
        subject.EyeRadius = 0f;
        var painter = new CoatPainter(brown, subject);
        Assert.True(1.25f * Luminance(painter.At(Address(SurfaceRegion.Body, 1, 2), front + Vector3.UnitY, Vector3.UnitZ)) < Luminance(painter.At(Address(SurfaceRegion.Body, 5, 2), front + Vector3.UnitY, Vector3.UnitZ)));
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

    [Fact]
    public void A_head_is_paler_or_darker_than_its_trunk_and_goes_over_into_it_along_the_neck()
    {
        foreach (double lightness in new[] { 0.25, 0.4, 0.5, 0.6, 0.7, 0.85 })
        {
            var painter = new CoatPainter(black with { Base = black.Base with { Lightness = lightness } }, Unmarked(HeadMark.None));
            double[] flank = Enumerable.Range(10, 16).Select(ring => Math.Cbrt(Luminance(painter.At(Address(SurfaceRegion.Body, ring, 7), new Vector3(0.2f, 1.02f, 0.3f), Vector3.UnitX)))).ToArray();
            Assert.True(Math.Abs(flank[0] - flank[15]) > 0.05, FormattableString.Invariant($"lightness {lightness}: {flank[0]:0.000} of the head, {flank[15]:0.000} of the trunk"));
            AssertGradual(flank);
        }
    }

    [Fact]
    public void A_hood_runs_out_along_the_neck()
    {
        CoatBlueprint white = black with { Pattern = black.Pattern with { Lightness = 0.95 }, Limb = black.Limb with { Lightness = 0.95 }, Accent = black.Accent with { Lightness = 0.95 } };
        var painter = new CoatPainter(white, Unmarked(HeadMark.Hood));
        double[] flank = Enumerable.Range(10, 16).Select(ring => Math.Cbrt(Luminance(painter.At(Address(SurfaceRegion.Body, ring, 7), new Vector3(0.2f, 1.02f, 0.3f), Vector3.UnitX)))).ToArray();
        Assert.True(flank[0] - flank[15] > 0.3, FormattableString.Invariant($"{flank[0]:0.000} of the hood, {flank[15]:0.000} of the trunk"));
        AssertGradual(flank);
    }

    [Theory]
    [InlineData(HeadMark.Crown, 10, 1)]
    [InlineData(HeadMark.Mask, 10, 4)]
    [InlineData(HeadMark.Blaze, 9, 0)]
    [InlineData(HeadMark.Cheek, 13, 9)]
    public void A_marking_is_told_from_the_face_though_its_colour_is_that_of_the_coat(object mark, int ring, int segment)
    {
        foreach (double lightness in new[] { 0.3, 0.5, 0.7, 0.85 })
        {
            var tint = new ColourBlueprint(lightness, 0.04, 1.1);
            CoatBlueprint plain = black with { Base = tint, Back = tint, Belly = tint, Pattern = tint, Limb = tint };
            Assert.True(Math.Abs(At(plain, (HeadMark)mark) - At(plain, HeadMark.None)) > 0.08, FormattableString.Invariant($"{mark} on lightness {lightness}"));
        }

        double At(CoatBlueprint coat, HeadMark worn) => Math.Cbrt(Luminance(new CoatPainter(coat, Unmarked(worn)).At(Address(SurfaceRegion.Body, ring, segment), new Vector3(0.1f, 1.15f, 0.7f), Vector3.UnitX)));
    }

    /// <summary>No step from ring to ring is more than a third of the whole.</summary>
    private static void AssertGradual(double[] along)
    {
        double whole = Math.Abs(along[0] - along[along.Length - 1]);
        for (int i = 1; i < along.Length; i++)
        {
            Assert.True(Math.Abs(along[i] - along[i - 1]) < 0.34 * whole, FormattableString.Invariant($"a seam at ring {10 + i}"));
        }
    }

    private static CoatSubject Unmarked(HeadMark mark)
    {
        CoatSubject subject = StraightSkin.Subject();
        subject.Snout = SnoutKind.Bare;
        subject.Mark = mark;
        return subject;
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
