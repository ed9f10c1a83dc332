using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FacePlanesTests
{
    /// <summary>How far a skull is above the eyes at least, in their radii.</summary>
    private const double HalfAnEye = 0.1;

    [Fact]
    public void A_broad_face_of_a_mixed_swimmer_rises_in_the_middle_and_is_hollow_beside_it()
    {
        int broad = 0;
        for (ulong seed = 10320001; seed <= 10320060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            if (face.Snout == SnoutKind.Beak || face.Class == AnimalClass.Arthropod || shape.Width[10] < 1.3 * 0.5 * (shape.Top[10] + shape.Bottom[10]))
            {
                continue;
            }

            // The same head without what models its top.
            HeadBlueprint bare = creature.Head with { Bumps = new ValueList<HeadBump>(creature.Head.Bumps.Where(bump => bump is not { Ring: 6, Segment: 0 } and not { Ring: 7, Segment: 3.2 })) };
            BodySkin modelled = BodySkin.Span(shape, creature);
            BodySkin board = BodySkin.Span(shape, creature with { Head = bare });
            Assert.True(Relief(modelled, shape) > Relief(board, shape) + 0.03);
            broad++;
        }

        Assert.True(broad > 5);
    }

    [Fact]
    public void Brows_of_mixed_swimmers_are_ridges_and_not_corners()
    {
        for (ulong seed = 10320001; seed <= 10320060; seed++)
        {
            HeadBlueprint head = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming }).Head;
            Assert.All(head.Bumps.Where(bump => bump is { Ring: 9.2, Segment: 4.2 }), bump => Assert.InRange(bump.Amount, 0, 0.1201));
        }
    }

    [Fact]
    public void Beaks_on_other_bodies_have_a_ridge_along_their_top()
    {
        int beaks = 0;
        for (ulong seed = 11030001; seed <= 11030150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (creature.Body.Blend.Face == creature.Body.Blend.First || SpeciesCatalogue.Find(creature.Body.Blend.Face).Snout != SnoutKind.Beak)
            {
                continue;
            }

            // The same beak without its planes is an ellipse.
            HeadBlueprint round = creature.Head with { Bumps = new ValueList<HeadBump>(creature.Head.Bumps.Where(bump => bump is not { Ring: 2, Segment: 0 } and not { Ring: 2, Segment: 3.4 })) };
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            Assert.True(Sharpness(BodySkin.Span(shape, creature)) > 1.2f * Sharpness(BodySkin.Span(shape, creature with { Head = round })));
            beaks++;
        }

        Assert.NotEqual(0, beaks);

        static float Sharpness(BodySkin skin) => (skin[2, 0] - skin.Shape.Centre(2)).Length() / (skin[2, 3] - skin.Shape.Centre(2)).Length();
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Swimming)]
    public void Eyes_on_the_skull_of_another_body_are_large_and_high_enough_to_be_seen_from_the_front(RequestedKind kind)
    {
        for (ulong seed = 11030001; seed <= 11030300; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
            if (face.Body != creature.Body.Blend.First && face.Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double half = 0.5 * (shape.Width[StationRing.Brow] + (0.5 * (shape.Top[StationRing.Brow] + shape.Bottom[StationRing.Brow])));
                EyeBlueprint eyes = creature.Head.Eyes;
                Assert.True(eyes.Radius > 0.215 * half && eyes.Segment < 6.35, FormattableString.Invariant($"{seed}: eyes of {eyes.Radius / half:0.00} at {eyes.Segment:0.0}"));
            }
        }
    }

    [Fact]
    public void Every_face_of_flesh_of_a_mixed_creature_that_does_not_swim_has_sockets_under_brows_unless_its_eyes_are_on_top()
    {
        for (ulong seed = 11030001; seed <= 11030100; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
            if (face.Snout != SnoutKind.Beak && face.Class != AnimalClass.Arthropod && face.Eye.Segment >= 5.2)
            {
                (double ring, double segment) = face.Eye;
                Assert.Contains(creature.Head.Bumps, bump => bump.Ring == ring - 0.6 && bump.Segment == segment + 0.2 && bump.Amount < -0.08);
                Assert.Contains(creature.Head.Bumps, bump => bump.Ring == ring - 1.6 && bump.Segment == segment - 1.9 && bump.Amount > 0.02);
            }
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void The_skull_of_a_strange_creature_ashore_rises_above_its_eyes_and_they_look_ahead(RequestedKind kind)
    {
        int faces = 0;
        for (ulong seed = 22259100; seed < 22259160; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
            EyeBlueprint eyes = creature.Head.Eyes;
            if (face.Snout == SnoutKind.Beak || face.Class == AnimalClass.Arthropod || eyes.Segment < 4.8)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            BodySkin skin = BodySkin.Span(shape, creature);
            SurfacePoint place = skin.At(eyes.Ring, eyes.Segment);
            double top = Above(place.Position - (place.Normal * (float)(eyes.Sink * eyes.Radius))) + eyes.Radius;
            double crown = Enumerable.Range(9, 5).Max(ring => Above(skin[ring, 0]));
            Assert.True(crown > top + (HalfAnEye * eyes.Radius), FormattableString.Invariant($"{seed}: a skull of {crown:0.000} over eyes up to {top:0.000} with a radius of {eyes.Radius:0.000}"));
            Assert.True(eyes.Forward > 0.6, FormattableString.Invariant($"{seed}: {eyes.Forward:0.00}"));
            faces++;

            double Above(System.Numerics.Vector3 point) => System.Numerics.Vector3.Dot(point - shape.Centre(StationRing.Brow), shape.Up(StationRing.Brow));
        }

        Assert.True(faces > 8, $"{faces} faces");
    }

    [Fact]
    public void The_front_of_a_mixed_swimmers_muzzle_is_narrower_than_its_face_by_a_quarter()
    {
        int broad = 0;
        for (ulong seed = 10320001; seed <= 10320150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
            if (face.Snout == SnoutKind.Beak || face.Class == AnimalClass.Arthropod)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            BodySkin skin = BodySkin.Span(shape, creature);
            double breadth = Breadth(skin, 2) / System.Math.Max(Breadth(skin, 10), Breadth(skin, 13));
            broad += shape.Width[2] > 0.7 * System.Math.Max(shape.Width[10], shape.Width[13]) ? 1 : 0;
            Assert.True(breadth < 0.75, System.FormattableString.Invariant($"{seed}: {breadth:0.00}"));
        }

        Assert.NotEqual(0, broad);
    }

    private static double Breadth(BodySkin skin, int ring) => Enumerable.Range(0, BodyGrid.Segments).Max(segment => skin[ring, segment].X);

    /// <summary>How far the middle of the top of the muzzle rises above the skin beside it, in heights of the section.</summary>
    private static double Relief(BodySkin skin, BodyShape shape) =>
        System.Numerics.Vector3.Dot(skin[7, 0] - skin[7, 3], shape.Up(7)) / shape.Top[7];
}
