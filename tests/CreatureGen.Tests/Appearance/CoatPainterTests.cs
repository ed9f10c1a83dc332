using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using Xunit;
using static CreatureGen.Tests.Appearance.StraightSkin;

namespace CreatureGen.Tests.Appearance;

public sealed class CoatPainterTests
{
    private static readonly CoatBlueprint tabby = new(
        new(0.62, 0.08, 1.1), new(0.48, 0.08, 1.0), new(0.85, 0.04, 1.2), new(0.35, 0.06, 1.0), new(0.30, 0.05, 0.9), new(0.65, 0.15, 4.2),
        new(0.25, 0.02, 1), new(0.6, 0.03, 1.3), new(0.25, 0.03, 0.5), new(0.45, 0.12, 0.35), new(0.6, 0.11, 0.25), new(0.7, 0.14, 1.6), PatternKind.Stripes, 1, 0.85, 7);

    [Fact]
    public void Both_sides_get_identical_colours()
    {
        SurfaceBuilder surface = Tube(out Vector3[] normals);
        Vector3[] colours = Paint(surface, normals, tabby, Subject());
        for (int v = 0; v < colours.Length; v++)
        {
            Assert.Equal(colours[v], colours[surface.Mirror[v]]);
        }
    }

    [Fact]
    public void The_order_of_the_vertices_does_not_matter()
    {
        SurfaceBuilder surface = Tube(out Vector3[] normals);
        Vector3[] forward = Paint(surface, normals, tabby, Subject());
        var reversed = new SurfaceBuilder();
        int last = forward.Length - 1;
        for (int v = last; v >= 0; v--)
        {
            reversed.Add(surface.Positions[v], surface.Addresses[v]);
            reversed.Mirror[last - v] = last - surface.Mirror[v];
        }

        Vector3[] backward = Paint(reversed, normals.Reverse().ToArray(), tabby, Subject());
        Assert.Equal(forward, backward.Reverse());
    }

    [Fact]
    public void A_single_vertex_of_the_right_side_is_painted_like_the_left()
    {
        var painter = new CoatPainter(tabby, Subject());
        Vector3 left = painter.At(Address(SurfaceRegion.Body, 30, 6), new Vector3(0.2f, 1f, 0.1f), Vector3.UnitX);
        VertexAddress right = Address(SurfaceRegion.Body, 30, 26);
        right.Sign = -1;
        Assert.Equal(left, painter.At(right, new Vector3(-0.2f, 1f, 0.1f), -Vector3.UnitX));
    }

    [Fact]
    public void Colours_stay_in_range_for_every_pattern_snout_tail_and_mark()
    {
        SurfaceBuilder surface = Tube(out Vector3[] normals);
        foreach (PatternKind kind in Enum.GetValues<PatternKind>())
        {
            foreach (SnoutKind snout in Enum.GetValues<SnoutKind>())
            {
                CoatSubject subject = Subject();
                subject.Snout = snout;
                subject.Tail = (TailStyle)((int)kind % 6);
                subject.Mark = (HeadMark)((int)kind % Enum.GetValues<HeadMark>().Length);
                Assert.All(Paint(surface, normals, tabby with { PatternKind = kind }, subject), c =>
                {
                    Assert.InRange(Math.Min(c.X, Math.Min(c.Y, c.Z)), 0.001f, 1f);
                    Assert.InRange(Math.Max(c.X, Math.Max(c.Y, c.Z)), 0.001f, 1f);
                });
            }
        }
    }

    [Fact]
    public void The_belly_is_pale_and_the_back_dark()
    {
        var painter = new CoatPainter(tabby with { PatternStrength = 0 }, Subject());
        Vector3 back = painter.At(Address(SurfaceRegion.Body, 32, 0), new Vector3(0f, 1.2f, 0f), Vector3.UnitY);
        Vector3 flank = painter.At(Address(SurfaceRegion.Body, 32, 8), new Vector3(0.2f, 1f, 0f), Vector3.UnitX);
        Vector3 belly = painter.At(Address(SurfaceRegion.Body, 32, 16), new Vector3(0f, 0.8f, 0f), -Vector3.UnitY);
        Assert.True(back.Y < 0.85f * flank.Y);
        Assert.True(belly.Y > 1.5f * flank.Y);
        Assert.Equal(OklchColour.ToLinearRgb(tabby.Belly).Y, belly.Y, 0.12f);
    }

    [Fact]
    public void Extremities_take_the_limb_colour_and_hooves_the_claw_colour()
    {
        var painter = new CoatPainter(tabby, Subject());
        Vector3 limb = OklchColour.ToLinearRgb(tabby.Limb);
        Assert.True(Distance(Leg(painter, SurfaceRegion.Leg, 0.95f), limb) < 0.5f * Distance(Leg(painter, SurfaceRegion.Leg, 0.1f), limb));
        Assert.True(Distance(Leg(painter, SurfaceRegion.Toe, 1f), limb) < 0.3f * Distance(Leg(painter, SurfaceRegion.Leg, 0.1f), limb));
        Assert.True(Distance(Leg(painter, SurfaceRegion.Hoof, 1f), OklchColour.ToLinearRgb(tabby.Claw)) < 0.03f);
    }

    [Fact]
    public void The_root_of_a_leg_continues_the_colour_of_the_body()
    {
        var painter = new CoatPainter(tabby with { PatternKind = PatternKind.Saddle }, Subject());
        var position = new Vector3(0.2f, 1f, 0.1f);
        VertexAddress root = Address(SurfaceRegion.Leg, 30, 9);
        Vector3 body = painter.At(Address(SurfaceRegion.Body, 30, 9), position, Vector3.UnitX);
        Assert.True(Distance(body, painter.At(root, position, Vector3.UnitX)) < 1e-6f);
    }

    [Fact]
    public void A_thigh_whose_root_reaches_the_belly_is_pale_on_its_inner_side_and_not_behind()
    {
        var painter = new CoatPainter(tabby with { PatternStrength = 0 }, Subject());
        var position = new Vector3(0.1f, 0.8f, -0.5f);
        VertexAddress thigh = Address(SurfaceRegion.Leg, 42, 13);
        thigh.Along = 0.12f;
        Vector3 belly = OklchColour.ToLinearRgb(tabby.Belly);
        float inner = Distance(painter.At(thigh, position, -Vector3.UnitX), belly);
        float behind = Distance(painter.At(thigh, position, -Vector3.UnitZ), belly);
        Assert.True(inner < 0.5f * behind, FormattableString.Invariant($"{inner} and {behind} from the belly"));
    }

    [Fact]
    public void Mouth_and_ears_have_colours_of_their_own()
    {
        var painter = new CoatPainter(tabby, Subject());
        Vector3 mouth = painter.At(Address(SurfaceRegion.Mouth, 4, 12), new Vector3(0f, 1f, 1f), Vector3.UnitY);
        Assert.True(mouth.X > 2f * mouth.Y && mouth.X < 0.25f, "dark red");
        Vector3 ear = painter.At(Address(SurfaceRegion.EarInside, 14, 3), new Vector3(0.1f, 1.2f, 0.8f), Vector3.UnitZ);
        Assert.True(ear.X > 1.3f * ear.Y && ear.X > 0.3f, "pinkish");
    }

    [Fact]
    public void A_nose_is_dark_a_beak_has_its_colour_and_lips_are_darker_than_their_skin()
    {
        CoatSubject subject = Subject();
        subject.Snout = SnoutKind.Leather;
        var front = new Vector3(0.02f, 1.02f, 1.2f);
        Vector3 nose = new CoatPainter(tabby, subject).At(Address(SurfaceRegion.Nose, 0, 4), new NosePad(subject.Body).Centre, Vector3.UnitZ);
        Assert.True(Distance(nose, OklchColour.ToLinearRgb(tabby.Muzzle)) < 0.06f);
        subject.Snout = SnoutKind.Beak;
        CoatBlueprint bird = tabby with { Muzzle = new(0.72, 0.15, 1.1) };
        Vector3 beak = new CoatPainter(bird, subject).At(Address(SurfaceRegion.Body, 2, 6), front, Vector3.UnitZ);
        Vector3 orange = OklchColour.ToLinearRgb(bird.Muzzle);
        Assert.True(Distance(beak / beak.X, orange / orange.X) < 0.1f);
        subject.Snout = SnoutKind.Bare;
        Vector3[] lip = { front + new Vector3(0.1f, 0f, -0.2f), front };
        subject.Lips = new MouthLine(lip, lip, 7, 0.05f);
        var bare = new CoatPainter(tabby, subject);
        Assert.True(bare.At(Address(SurfaceRegion.Lip, 5, 10), front, Vector3.UnitX).Y < 0.6f * bare.At(Address(SurfaceRegion.Body, 5, 10), front + new Vector3(0f, 0.02f, 0f), Vector3.UnitX).Y);
    }

    [Fact]
    public void The_skin_around_an_eye_changes_and_far_from_it_does_not()
    {
        CoatSubject with = Subject();
        with.EyeCentre = new Vector3(0.15f, 1.05f, 0.8f);
        with.EyeRadius = 0.04f;
        var ringed = new CoatPainter(tabby, with);
        var plain = new CoatPainter(tabby, Subject());
        VertexAddress at = Address(SurfaceRegion.Body, 10, 6);
        Assert.True(Distance(ringed.At(at, new Vector3(0.16f, 1.08f, 0.8f), Vector3.UnitX), plain.At(at, new Vector3(0.16f, 1.08f, 0.8f), Vector3.UnitX)) > 0.03f);
        Assert.Equal(plain.At(at, new Vector3(0.16f, 1.2f, 0.8f), Vector3.UnitX), ringed.At(at, new Vector3(0.16f, 1.2f, 0.8f), Vector3.UnitX));
    }

    [Fact]
    public void Fins_carry_rays_and_wings_their_style()
    {
        CoatSubject subject = Subject();
        subject.WingStyles = new[] { WingStyle.Bat, WingStyle.Feathered };
        var painter = new CoatPainter(tabby, subject);
        float[] fin = Enumerable.Range(0, 60).Select(k => painter.At(Blade(SurfaceRegion.Fin, 0, k / 60f), new Vector3(0f, 1.4f, 0f), Vector3.UnitX).Z).ToArray();
        int rises = Enumerable.Range(1, 58).Count(k => fin[k] > fin[k - 1] && fin[k] > fin[k + 1]);
        Assert.InRange(rises, 6, 12);
        Vector3 membrane = painter.At(Blade(SurfaceRegion.Wing, 0, 0.7f), new Vector3(0.6f, 1.2f, 0f), Vector3.UnitY);
        Vector3 feather = painter.At(Blade(SurfaceRegion.Wing, 1, 0.9f), new Vector3(0.6f, 1.2f, 0f), Vector3.UnitY);
        Vector3 limb = OklchColour.ToLinearRgb(tabby.Limb);
        Assert.True(Distance(feather, limb) < 0.25f * Distance(OklchColour.ToLinearRgb(tabby.Base), limb));
        Assert.True(Distance(membrane, feather) > 0.03f);
    }

    [Fact]
    public void Edges_of_fins_that_lead_keep_the_coat_of_the_body()
    {
        var position = new Vector3(0f, 1.4f, 0f);
        var painter = new CoatPainter(tabby, Subject());
        Vector3 body = painter.At(Address(SurfaceRegion.Body, 27, 6), position, Vector3.UnitX);
        Vector3 lead = painter.At(Blade(SurfaceRegion.Fin, 0, 0f), position, Vector3.UnitX);
        Vector3 middle = painter.At(Blade(SurfaceRegion.Fin, 0, 0.5f), position, Vector3.UnitX);
        Assert.True(Distance(lead, body) < 0.4f * Distance(middle, body));

        // On a ray in the middle of the blade and on the edge; flukes lie level.
        Vector3 fin = BladeCoat.FinColour(new CoatPalette(tabby), tabby.PatternSeed);
        foreach ((TailStyle style, int edge, int blade) in new[] { (TailStyle.Fluke, 8, 4), (TailStyle.Fan, 0, 4), (TailStyle.Fork, 16, 12) })
        {
            CoatSubject subject = Subject();
            subject.Tail = style;
            var tail = new CoatPainter(tabby, subject);
            float At(int segment) => Distance(tail.At(Address(SurfaceRegion.Body, 51, segment), position, Vector3.UnitX), fin);
            Assert.True(At(edge) > 2f * At(blade), $"{style}: {At(edge)} and {At(blade)} from the colour of fins");
        }
    }

    [Fact]
    public void Head_marks_come_from_the_seed_in_every_kind()
    {
        var seen = Enumerable.Range(0, 300).Select(HeadMarks.FromSeed).GroupBy(m => m).ToDictionary(g => g.Key, g => g.Count());
        Assert.Equal(Enum.GetValues<HeadMark>().Length, seen.Count);
        Assert.InRange(seen[HeadMark.None], 45, 105);
    }

    [Theory]
    [InlineData(PatternKind.Patches)]
    [InlineData(PatternKind.Giraffe)]
    [InlineData(PatternKind.Bands)]
    [InlineData(PatternKind.Turing)]
    public void Broad_fields_of_a_pattern_leave_the_face_and_the_shins(PatternKind kind)
    {
        var patterned = new CoatPainter(tabby with { PatternKind = kind }, Subject());
        var plain = new CoatPainter(tabby with { PatternKind = kind, PatternStrength = 0 }, Subject());
        Assert.True(Seen(9) < 0.4f * Seen(24), FormattableString.Invariant($"{Seen(9):0.000} on the face, {Seen(24):0.000} on the trunk"));
        Assert.True(Shin(0.75f) < 0.4f * Shin(0.1f), FormattableString.Invariant($"{Shin(0.75f):0.000} on the shin, {Shin(0.1f):0.000} on the thigh"));

        float Seen(int ring) => Enumerable.Range(0, 90).Max(step => Of(Address(SurfaceRegion.Body, ring, 6), new Vector3(0.2f, 1f, 1.2f - (0.03f * step))));

        float Shin(float along)
        {
            VertexAddress leg = Address(SurfaceRegion.Leg, 30, 10);
            leg.Along = along;
            return Enumerable.Range(0, 90).Max(step => Of(leg, new Vector3(0.2f, 0.4f, 1.2f - (0.03f * step))));
        }

        float Of(VertexAddress address, Vector3 place) => Distance(patterned.At(address, place, Vector3.UnitX), plain.At(address, place, Vector3.UnitX));
    }

    private static Vector3 Leg(CoatPainter painter, SurfaceRegion region, float along)
    {
        VertexAddress address = Address(region, 30, 10);
        address.Along = along;
        return painter.At(address, new Vector3(0.2f, 0.8f - (0.8f * along), 0.1f), Vector3.UnitX);
    }

    private static VertexAddress Blade(SurfaceRegion region, int appendage, float around)
    {
        VertexAddress address = Address(region, 27, 6);
        address.Appendage = (short)appendage;
        address.Along = 0.6f;
        address.Around = around * MathF.PI;
        return address;
    }

    private static float Distance(Vector3 a, Vector3 b) => Vector3.Distance(a, b);

    private static SurfaceBuilder Tube(out Vector3[] normals)
    {
        var surface = new SurfaceBuilder();
        normals = new Vector3[BodyGrid.Rings * BodyGrid.Segments];
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            for (int j = 0; j < BodyGrid.Segments; j++)
            {
                double angle = 2 * Math.PI * Math.Min(j, 32 - j) / 32;
                var normal = new Vector3((float)Math.Sin(angle) * (j > 16 ? -1 : 1), (float)Math.Cos(angle), 0f);
                VertexAddress address = Address(SurfaceRegion.Body, i, j);
                address.Sign = (sbyte)(j > 16 ? -1 : 1);
                int v = surface.Add(new Vector3(0f, 1f, 1.2f - (0.04f * i)) + (normal * 0.2f), address);
                surface.Mirror[v] = (i * BodyGrid.Segments) + BodyGrid.MirrorSegment(j);
                normals[v] = normal;
            }
        }

        return surface;
    }

    private static Vector3[] Paint(SurfaceBuilder surface, Vector3[] normals, CoatBlueprint coat, CoatSubject subject)
    {
        var colours = new Vector3[surface.Positions.Count];
        new CoatPainter(coat, subject).Paint(surface.Addresses.ToArray(), surface.Positions.ToArray(), surface.Mirror.ToArray(), normals, colours);
        return colours;
    }
}
