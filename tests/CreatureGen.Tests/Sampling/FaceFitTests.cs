using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Features;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class FaceFitTests
{
    private const ulong First = 11200001;
    private const int Count = 120;

    /// <summary>Most that nineteen of twenty faces are held up, degrees: what the bend of the nape leaves of the rule's 3 (10 without).</summary>
    private const double HighestFace = 5;

    /// <summary>Fall of a face, degrees, that all but one of twelve over legs have: what the bend of the nape leaves of the rule's 10 (one of five has not without it).</summary>
    private const double LevelFace = 2;

    /// <summary>Shortest face of another body on a swimmer in heights of its brow: what the greatest factor on a snout leaves of the rule's .85 (.36 without).</summary>
    private const double ShortestFace = 0.45;

    /// <summary>Flattest head of another body in breadths for each height of its brow: what the slices behind it leave of the rule's 1.75 (3.3 without).</summary>
    private const double FlattestHead = 2.1;

    /// <summary>Smallest head of another body in trunks: what the greatest factor on a head leaves of the rule's .42 (.33 without).</summary>
    private const double SmallestHead = 0.36;

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void Faces_of_mixed_creatures_are_not_held_up(RequestedKind kind)
    {
        int faces = 0;
        int up = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(kind, 0.6, First, Count))
        {
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                double rise = 180 / Math.PI * Math.Atan2(shape.Y[StationRing.Nose] - shape.Y[StationRing.Brow], shape.Z[StationRing.Nose] - shape.Z[StationRing.Brow]);
                up += rise > HighestFace ? 1 : 0;
                faces++;
            }
        }

        Assert.True(20 * up <= faces, FormattableString.Invariant($"{kind}: {up} of {faces} faces are held up"));
    }

    /// <summary>Open to their rims, the eyes of a frog on a theropod were goggles.</summary>
    [Theory]
    [InlineData(24832002, RequestedKind.Walking)]
    [InlineData(24832002, RequestedKind.Swimming)]
    public void Eyes_on_top_of_a_strange_head_have_lids_over_them(ulong seed, RequestedKind kind)
    {
        EyeBlueprint eyes = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind }).Head.Eyes;
        Assert.True(eyes.Segment < 4.6 && eyes.UpperLid < 0.9 && eyes.LowerLid < 1.1, FormattableString.Invariant($"open by {eyes.UpperLid:0.00} and {eyes.LowerLid:0.00} at segment {eyes.Segment}"));
    }

    [Fact]
    public void Eyes_on_top_of_strange_heads_are_smaller_than_those_of_the_animals_that_have_them_there()
    {
        double animals = MeanSize(0);
        double strange = MeanSize(0.6);
        Assert.True(strange < 0.92 * animals, FormattableString.Invariant($"{strange:0.000} of half the head, {animals:0.000} of animals"));

        static double MeanSize(double strangeness)
        {
            double sum = 0;
            int heads = 0;
            foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, strangeness, First, 4 * Count))
            {
                SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
                if (face.Eye.Segment <= 4.2 && face.Class == AnimalClass.Amphibian && !creature.Head.Eyes.IsSingle)
                {
                    sum += creature.Head.Eyes.Radius / HeadSampler.HalfHeight(shape);
                    heads++;
                }
            }

            return sum / heads;
        }
    }

    [Fact]
    public void Faces_over_legs_look_down_to_who_stands_before_them()
    {
        int faces = 0;
        int level = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, 0.6, First, Count))
        {
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod && (PlanTraits.IsAboveLegs(creature.Plan) || creature.Plan is BodyPlan.Theropod or BodyPlan.Upright))
            {
                double fall = 180 / Math.PI * Math.Atan2(shape.Y[StationRing.Brow] - shape.Y[StationRing.Nose], shape.Z[StationRing.Nose] - shape.Z[StationRing.Brow]);
                level += fall < LevelFace ? 1 : 0;
                faces++;
            }
        }

        Assert.InRange(faces, 20, Count);
        Assert.True(12 * level <= faces, FormattableString.Invariant($"{level} of {faces} faces show their chin"));
    }

    [Fact]
    public void The_face_of_another_body_on_a_swimmer_is_not_its_blunt_end()
    {
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Swimming, 1, First, Count))
        {
            if (IsOfAnother(creature))
            {
                double length = (shape.Arc[StationRing.Brow] - shape.Arc[StationRing.Nose]) / HeightOf(shape, StationRing.Brow);
                Assert.True(length >= ShortestFace, FormattableString.Invariant($"{creature.Seed}: a face of {length:0.00} heights"));
            }
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Swimming)]
    public void The_head_of_another_body_is_neither_a_board_nor_a_knob(RequestedKind kind)
    {
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(kind, 1, First, Count))
        {
            if (IsOfAnother(creature))
            {
                double breadth = 2 * shape.Width[StationRing.Brow] / HeightOf(shape, StationRing.Brow);
                double size = Largest(shape, 3, 14) / Largest(shape, 23, 42);
                Assert.True(breadth <= FlattestHead, FormattableString.Invariant($"{kind} {creature.Seed}: a head of {breadth:0.00} heights' breadth"));
                Assert.True(size >= SmallestHead, FormattableString.Invariant($"{kind} {creature.Seed}: a head of {size:0.00} trunks"));
            }
        }
    }

    private static bool IsOfAnother(CreatureBlueprint creature)
    {
        SpeciesProfile face = SpeciesCatalogue.Find(creature.Body.Blend.Face);
        return creature.Body.Blend.Face != creature.Body.Blend.First && face.Snout != SnoutKind.Beak && face.Class != AnimalClass.Arthropod
            && SpeciesCatalogue.Find(creature.Body.Blend.First).Disc.Sweep == 0;
    }

    private static double HeightOf(BodyShape shape, int ring) => shape.Top[ring] + shape.Bottom[ring];

    private static double Largest(BodyShape shape, int first, int last)
    {
        double largest = 0;
        for (int ring = first; ring <= last; ring++)
        {
            largest = Math.Max(largest, Math.Sqrt(shape.Width[ring] * 0.5 * HeightOf(shape, ring)));
        }

        return largest;
    }
}
