using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Genetics;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Repairs;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Features;

public sealed class BeakTests
{
    private static readonly Vector3 horn = new(0.7f, 0.5f, 0.1f);

    public static TheoryData<BeakStyle> Styles => new(Enum.GetValues<BeakStyle>());

    [Theory]
    [InlineData("duck", BeakStyle.Flat)]
    [InlineData("ostrich", BeakStyle.Flat)]
    [InlineData("heron", BeakStyle.Probe)]
    [InlineData("raptor", BeakStyle.Hooked)]
    [InlineData("owl", BeakStyle.Hooked)]
    [InlineData("parrot", BeakStyle.Parrot)]
    [InlineData("toucan", BeakStyle.Large)]
    [InlineData("rooster", BeakStyle.Conical)]
    public void A_bird_of_the_catalogue_wears_the_beak_of_its_own_family(string body, BeakStyle style) =>
        Assert.All(SpeciesTests.Drawn(body, RequestedKind.Walking), bird => Assert.Equal(style, bird.Head.Beak?.Style));

    [Theory]
    [InlineData("feline")]
    [InlineData("pterosaur")]
    [InlineData("bee")]
    public void Who_is_no_bird_has_no_beak(string body) =>
        Assert.All(SpeciesTests.Drawn(body, RequestedKind.Flying), other => Assert.Null(other.Head.Beak));

    [Theory]
    [MemberData(nameof(Styles))]
    public void Both_bills_of_every_family_are_closed_and_symmetric_on_every_bird(BeakStyle style)
    {
        foreach (CreatureBlueprint bird in Birds(style))
        {
            foreach (Piece bill in Bills(bird))
            {
                PieceChecks.IsSound(bill);
                PieceChecks.IsSymmetric(bill);
                PieceChecks.NormalsFollowFaces(bill, 0.85);
                Assert.InRange(PieceChecks.TriangleCount(bill), 250, 560);
            }
        }
    }

    [Theory]
    [MemberData(nameof(Styles))]
    public void The_nose_of_every_bird_lies_within_its_horn(BeakStyle style)
    {
        foreach (CreatureBlueprint bird in Birds(style).Select(Shut))
        {
            GrownSurface grown = GrownSurface.Grow(bird);
            Piece[] bills = Bills(bird);
            for (int v = 0; v < grown.Surface.Positions.Length; v++)
            {
                Vector3 nose = grown.Surface.Positions[v];
                if (grown.Surface.Addresses[v].Region == SurfaceRegion.Nose)
                {
                    Vector3 up = grown.Skin.Shape.Up(StationRing.Nose);
                    bool above = grown.Surface.Addresses[v].Segment is < BodyGrid.LipSegment or > BodyGrid.Segments - BodyGrid.LipSegment;
                    Assert.True(Hits(bills[above ? 0 : 1], nose, above ? up : -up) > 0, $"{bird.Body.Blend.Face}: the nose shows at {nose}");
                }
            }
        }
    }

    [Theory]
    [InlineData(0f, 0.08f, 0f)]
    [InlineData(1f, 0.0673f, 0.0368f)]
    public void The_tip_is_its_length_ahead_of_the_nose_along_an_arc(float turn, float ahead, float down)
    {
        Piece bill = OnTube(turn);
        Vector3 tip = bill.Positions[^1];
        Assert.Equal(0f, tip.X);
        Assert.Equal(ahead, tip.Z, 3);
        Assert.Equal(-down, tip.Y, 3);
        PieceChecks.IsSound(bill);
    }

    [Fact]
    public void The_edge_of_the_horn_stands_on_the_skin_and_its_end_is_below_it()
    {
        Piece bill = OnTube(0f);
        const int sides = 16;
        float end = bill.Positions.Take(sides).Max(p => p.Y);
        float edge = bill.Positions.Skip(sides).Take(sides).Max(p => p.Y);
        Assert.InRange(end, 0f, 0.0499f);
        Assert.InRange(edge, 0.0525f, 0.06f);
    }

    [Fact]
    public void The_upper_bill_laps_over_the_lower_one_where_jaws_are_shut()
    {
        foreach (CreatureBlueprint bird in Birds(BeakStyle.Hooked).Select(Shut))
        {
            GrownSurface grown = GrownSurface.Grow(bird);
            Piece upper = Bills(bird)[0];
            for (int ring = 1; ring <= 4; ring++)
            {
                // A little out and down from the lip is horn of the upper bill.
                Vector3 lip = grown.Surface.Positions[grown.BodyVertex(ring, BodyGrid.LipSegment)];
                float radius = (float)grown.Skin.Shape.Width[ring];
                Vector3 at = lip + (grown.Skin.At(ring, BodyGrid.LipSegment).Normal * (0.02f * radius)) - (grown.Skin.Shape.Up(ring) * (0.03f * radius));
                Assert.True(IsWithin(upper, at), $"{bird.Body.Blend.Face}: the lip shows at ring {ring}");
            }
        }
    }

    [Theory]
    [MemberData(nameof(Styles))]
    public void The_lower_bill_of_a_shut_beak_turns_with_the_upper_one_and_does_not_come_through_it(BeakStyle style)
    {
        foreach (CreatureBlueprint bird in Birds(style).Select(Shut))
        {
            Vector3 up = GrownSurface.Grow(bird).Skin.Shape.Up(StationRing.Nose);
            Piece[] bills = Bills(bird);
            int through = bills[1].Positions.Count(p => Hits(bills[0], p, up) == 0 && Hits(bills[0], p, -up) > 0);
            Assert.True(through <= 0.02 * bills[1].Positions.Length, $"{bird.Body.Blend.Face}: {through} corners of the lower bill are above the upper one");
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(0.1)]
    public void The_lower_bill_ends_where_the_jaw_does(double longer)
    {
        CreatureBlueprint drawn = SpeciesTests.Drawn("heron", RequestedKind.Walking).First();
        BeakBlueprint beak = drawn.Head.Beak! with { Length = longer * drawn.Head.Beak.Length };
        CreatureBlueprint heron = drawn with { Head = drawn.Head with { Beak = beak } };
        Creature creature = CreatureAssembler.Assemble(heron with { Scale = 1 });
        int end = creature.Skeleton.IndexOf("JawEnd");
        BodyShape shape = GrownSurface.Grow(heron).Skin.Shape;
        float ahead = Vector3.Dot(Bills(heron)[1].Positions[^1] - creature.Skeleton.ModelPositions[end], shape.Forward(StationRing.Nose));
        Assert.True(Math.Abs(ahead) < 0.15f * BillReach.Of(beak, shape).Lower, $"the tip is {ahead} m ahead of the jaw's end");
    }

    [Fact]
    public void A_beak_without_a_mouth_is_refused_and_taken_off_by_repair()
    {
        CreatureBlueprint bird = SpeciesTests.Drawn("duck", RequestedKind.Walking).First();
        CreatureBlueprint mute = bird with { Head = bird.Head with { Mouth = bird.Head.Mouth with { CornerRing = 0, Tongue = TongueStyle.None } } };
        Assert.Contains(BlueprintValidator.Validate(mute), problem => problem.Path == "head.beak");
        Assert.Null(BlueprintRepair.Repair(mute).Blueprint.Head.Beak);
    }

    [Fact]
    public void Text_keeps_a_beak_and_leaves_out_none()
    {
        CreatureBlueprint bird = SpeciesTests.Drawn("parrot", RequestedKind.Walking).First();
        Assert.Equal(bird, BlueprintJson.Read(BlueprintJson.Write(bird)).GetBlueprint());
        CreatureBlueprint bare = bird with { Head = bird.Head with { Beak = null } };
        string text = BlueprintJson.Write(bare);
        Assert.DoesNotContain("beak", text, StringComparison.Ordinal);
        Assert.Equal(bare, BlueprintJson.Read(text).GetBlueprint());
    }

    [Fact]
    public void Mutants_have_other_beaks_of_the_same_family_and_the_young_shorter_ones()
    {
        CreatureBlueprint bird = SpeciesTests.Drawn("raptor", RequestedKind.Walking).First();
        BeakBlueprint beak = bird.Head.Beak!;
        BeakBlueprint[] mutants = Enumerable.Range(0, 8).Select(i => Mutation.Mutate(bird, 0.5, new Seed((ulong)i)).Head.Beak!).ToArray();
        Assert.All(mutants, mutant => Assert.Equal(beak.Style, mutant.Style));
        Assert.True(mutants.Select(mutant => mutant.Length).Distinct().Count() > 6);
        Assert.Equal(0.7 * beak.Length, Ageing.At(bird, 0).Blueprint.Head.Beak!.Length, 6);
    }

    /// <summary>A bird of each body with a beak of a family, as long as that family's are.</summary>
    private static IEnumerable<CreatureBlueprint> Birds(BeakStyle style)
    {
        foreach (string body in new[] { "avian", "duck", "heron", "raptor", "toucan" })
        {
            CreatureBlueprint bird = SpeciesTests.Drawn(body, RequestedKind.Walking).First();
            yield return bird with { Head = bird.Head with { Beak = new BeakBlueprint(style, 0.04, 1, BeakForm.Of(style).Hook) } };
        }
    }

    private static CreatureBlueprint Shut(CreatureBlueprint bird) => bird with { Head = bird.Head with { Mouth = bird.Head.Mouth with { Opening = 0 } } };

    private static Piece[] Bills(CreatureBlueprint blueprint)
    {
        var beak = new BeakSetter(blueprint.Head.Beak!, blueprint.Head.Mouth, GrownSurface.Grow(blueprint));
        var builder = new PieceBuilder();
        builder.Clear(SurfaceFinish.Horn);
        beak.AppendUpper(builder, new CoatPalette(blueprint.Coat), horn);
        Piece upper = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
        builder.Clear(SurfaceFinish.Horn);
        beak.AppendLower(builder, horn);
        return [upper, builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere)];
    }

    /// <summary>An upper bill, 8 cm long, on a tube along z of 5 cm radius whose front is at z = 0.</summary>
    private static Piece OnTube(float turn)
    {
        const int rings = 9;
        const int columns = 6;
        var skin = new SurfacePoint[rings * columns];
        for (int i = 0; i < skin.Length; i++)
        {
            float angle = MathF.PI / 2f * (i % columns) / (columns - 1);
            var outward = new Vector3(i % columns == 0 ? 0f : MathF.Sin(angle), MathF.Cos(angle), 0f);
            skin[i] = new SurfacePoint((outward * 0.05f) - new Vector3(0f, 0f, 0.02f * (i / columns)), outward);
        }

        var face = new BillFace(skin, columns, Enumerable.Repeat(-Vector3.UnitY, rings).ToArray(), Enumerable.Repeat(0.05f, rings).ToArray(), Vector3.UnitZ);
        var builder = new PieceBuilder();
        new BillShape(face, new BillForm(), 1f) { Root = (6f, 6f), Length = 0.08f, Nose = 1e-4f, Turn = turn }.Append(builder, true, (_, _) => horn);
        return builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
    }

    private static bool IsWithin(Piece piece, Vector3 point) => Hits(piece, point, Vector3.Normalize(new Vector3(0.31f, 0.83f, 0.47f))) % 2 == 1;

    private static int Hits(Piece piece, Vector3 point, Vector3 direction)
    {
        int hits = 0;
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            hits += RayCast.Hit(point, direction, piece.Positions[piece.Triangles[t]], piece.Positions[piece.Triangles[t + 1]], piece.Positions[piece.Triangles[t + 2]], out _, out _, out _) ? 1 : 0;
        }

        return hits;
    }
}
