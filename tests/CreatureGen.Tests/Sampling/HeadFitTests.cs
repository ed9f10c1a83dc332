using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class HeadFitTests
{
    /// <summary>Largest head against its trunk, by the mean of breadth and height: what the posture leaves of the rule's 1.</summary>
    private const double Largest = 1.15;

    /// <summary>The same of swimmers, whose heads hide the trunk from the front: what is left of the rule's .8.</summary>
    private const double LargestOfSwimmers = 0.95;

    /// <summary>The same of those on two legs and in the air: what is left of the rule's .8.</summary>
    private const double LargestOnTwoLegs = 0.95;

    /// <summary>Thickest neck behind the head of another body against that: what the least that a neck keeps leaves of the rule's .95.</summary>
    private const double ThickestNeck = 1.1;

    /// <summary>Broadest head in breadths of its trunk: what the posture leaves of the rule's 1.15.</summary>
    private const double Broadest = 1.25;

    /// <summary>Most that a face falls away ahead of its brow, degrees: what the bend of the nape leaves of the rule's 11.5, and how single animals differ.</summary>
    private const double SteepestFace = 26;

    [Fact]
    public void Mixed_swimmers_without_a_beak_look_ahead_whosever_head_they_have()
    {
        for (ulong seed = 10310001; seed <= 10310150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Snout == SnoutKind.Beak)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double fall = 180 / Math.PI * Math.Atan2(shape.Y[10] - shape.Y[0], shape.Z[0] - shape.Z[10]);
            Assert.True(fall <= SteepestFace, FormattableString.Invariant($"{seed}: a face that falls by {fall:0} degrees"));
        }
    }

    [Fact]
    public void The_face_of_another_body_on_an_insect_looks_ahead()
    {
        int faces = 0;
        for (ulong seed = 11030001; seed <= 11030400; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            bool insect = SpeciesCatalogue.Find(creature.Body.Blend.First).Class == AnimalClass.Arthropod;
            if (insect && SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double fall = 180 / Math.PI * Math.Atan2(shape.Y[10] - shape.Y[0], shape.Z[0] - shape.Z[10]);
                Assert.True(fall <= SteepestFace, FormattableString.Invariant($"{seed}: a face that falls by {fall:0} degrees"));
                faces++;
            }
        }

        Assert.NotEqual(0, faces);
    }

    [Theory]
    [InlineData(RequestedKind.Walking, Largest)]
    [InlineData(RequestedKind.Flying, Largest)]
    [InlineData(RequestedKind.Swimming, LargestOfSwimmers)]
    public void No_head_of_a_mixed_creature_but_an_insects_is_larger_than_the_trunk_behind_it(RequestedKind kind, double largest)
    {
        for (ulong seed = 9794001; seed <= 9794060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double size = Size(shape, 3, 14) / Size(shape, 23, 42);
                Assert.True(size <= largest, FormattableString.Invariant($"{kind} {seed}: a head of {size:0.00} trunks"));
            }
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void No_head_of_a_mixed_creature_but_an_insects_is_broader_than_its_trunk_by_a_quarter_however_flat_it_is(RequestedKind kind)
    {
        for (ulong seed = 9943001; seed <= 9943150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            if (SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double breadth = Breadth(shape, 3, 14) / Breadth(shape, 23, 42);
                Assert.True(breadth <= Broadest, FormattableString.Invariant($"{kind} {seed}: a head of {breadth:0.00} trunks' breadth"));
            }
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking, 0.6)]
    [InlineData(RequestedKind.Walking, 1)]
    [InlineData(RequestedKind.Flying, 1)]
    public void Heads_of_mixed_creatures_on_two_legs_and_in_the_air_are_smaller_than_their_trunks(RequestedKind kind, double strangeness)
    {
        for (ulong seed = 9794001; seed <= 9794150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, Strangeness = strangeness });
            if (creature.Plan is BodyPlan.Theropod or BodyPlan.Flapping && SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double size = Size(shape, 3, 14) / Size(shape, 23, 42);
                Assert.True(size <= LargestOnTwoLegs, FormattableString.Invariant($"{kind} {seed}: a head of {size:0.00} trunks"));
            }
        }
    }

    [Fact]
    public void The_neck_behind_the_head_of_another_body_is_thinner_than_the_head()
    {
        for (ulong seed = 9794001; seed <= 9794150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 1 });
            if (creature.Body.Blend.Face != creature.Body.Blend.First && SpeciesCatalogue.Find(creature.Body.Blend.Face).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double neck = Size(shape, 18, 20) / Size(shape, 3, 14);
                Assert.True(neck <= ThickestNeck, FormattableString.Invariant($"{seed}: a neck of {neck:0.00} heads"));
            }
        }
    }

    private static double Breadth(BodyShape shape, int first, int last)
    {
        double width = 0;
        for (int ring = first; ring <= last; ring++)
        {
            width = Math.Max(width, shape.Width[ring]);
        }

        return width;
    }

    private static double Size(BodyShape shape, int first, int last)
    {
        double width = 0;
        double height = 0;
        for (int ring = first; ring <= last; ring++)
        {
            width = Math.Max(width, shape.Width[ring]);
            height = Math.Max(height, 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
        }

        return Math.Sqrt(width * height);
    }
}
