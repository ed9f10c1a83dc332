using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class TailFitTests
{
    /// <summary>Largest tail in sizes of its trunk: what the posture leaves of the rule's .8.</summary>
    private const double Largest = 0.95;

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void No_tail_of_a_mixed_creature_on_legs_but_of_an_insect_swells_to_the_size_of_its_trunk(RequestedKind kind)
    {
        int most = 0;
        for (ulong seed = 9951001; seed <= 9951150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            if (creature.Plan != BodyPlan.Legless && SpeciesCatalogue.Find(creature.Body.Blend.First).Class != AnimalClass.Arthropod)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double size = Size(shape, 47, 54) / Size(shape, 25, 42);
                Assert.True(size <= Largest, FormattableString.Invariant($"{kind} {seed}: a tail of {size:0.00} trunks"));
                most++;
            }
        }

        Assert.InRange(most, 60, 150);
    }

    private static double Size(BodyShape shape, int first, int last)
    {
        double size = 0;
        for (int ring = first; ring <= last; ring++)
        {
            size = Math.Max(size, Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring])));
        }

        return size;
    }
}
