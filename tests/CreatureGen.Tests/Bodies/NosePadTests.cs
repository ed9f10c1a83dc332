using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Sampling;
using CreatureGen.Tests.Features;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class NosePadTests
{
    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Swimming)]
    public void The_leather_of_a_nose_is_a_third_of_the_face_at_most_and_lies_on_the_front_of_the_muzzle(RequestedKind kind)
    {
        for (ulong seed = 10771001; seed <= 10771060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            var pad = new NosePad(shape);
            Assert.True(pad.HalfWidth <= shape.Width.Take(StationRing.Nape + 1).Max() / 3, $"{seed}");
            Assert.True(pad.HalfWidth < shape.Width[StationRing.Nose], $"{seed}");
            float above = Vector3.Dot(pad.Centre - shape.Centre(StationRing.Nose), pad.Up);
            Assert.True(above <= shape.Top[StationRing.Nose] && above - pad.HalfHeight >= -0.4 * shape.Bottom[StationRing.Nose], $"{seed}");
        }
    }

    [Fact]
    public void As_a_piece_it_is_a_closed_mirrored_cushion_that_stands_off_the_muzzle_on_every_mammal()
    {
        foreach (string body in new[] { "canine", "feline", "bovine", "bear", "horse" })
        {
            foreach (CreatureBlueprint mammal in SpeciesTests.Drawn(body, RequestedKind.Walking).Take(6))
            {
                GrownSurface grown = GrownSurface.Grow(mammal);
                var pad = new NosePad(grown.Skin.Shape);
                var muzzle = new MuzzleFront(grown.Surface, pad);
                var builder = new PieceBuilder();
                var bed = new NoseBed(pad, muzzle.Ahead);
                NosePadShape.Append(builder, bed, Vector3.One);
                Piece piece = builder.ToPiece(MaterialKind.Skin, PieceChecks.Anywhere);
                PieceChecks.IsSound(piece);
                PieceChecks.IsSymmetric(piece);
                Assert.InRange(PieceChecks.TriangleCount(piece), 80, 160);

                float crown = Vector3.Dot(piece.Positions[^1] - pad.Centre, pad.Forward);
                Assert.InRange(crown - muzzle.Ahead(pad.Centre), 0.05f * pad.HalfWidth, 0.4f * pad.HalfWidth);
                SurfacePoint nostril = NosePadShape.Nostril(bed);
                Assert.True(nostril.Position.X > 0.3f * pad.HalfWidth && Vector3.Dot(nostril.Normal, pad.Forward) > 0.4f, body);
            }
        }
    }

    [Fact]
    public void It_covers_the_nostrils_and_not_the_corners_of_a_broad_muzzle()
    {
        var shape = new BodyShape();
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            (shape.Width[i], shape.Top[i], shape.Bottom[i]) = (0.2, 0.1, 0.1);
        }

        var pad = new NosePad(shape);
        Assert.Equal(1, pad.At(pad.Centre));
        Assert.Equal(1, pad.At(pad.Nostril));
        Assert.Equal(0, pad.At(pad.Centre + (Vector3.UnitX * 0.1f)));
        Assert.Equal(0, pad.At(pad.Centre - (pad.Up * 0.1f)));
        Assert.True(pad.At(pad.Centre + new Vector3(0.9f * pad.HalfWidth, 0f, 0f)) > pad.At(pad.Centre + new Vector3(0.9f * pad.HalfWidth, -0.4f * pad.HalfHeight, 0f)));
    }
}
