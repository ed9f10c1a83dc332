using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class NeckFitTests
{
    private const ulong First = 12720001;
    private const int Count = 120;

    /// <summary>Least part of mixed creatures on legs under them whose heads are seen over their backs from behind (.85 without the rule, .98 with it).</summary>
    private const double Seen = 0.93;

    /// <summary>Broadest neck in chests that may be held up, and how steeply a broader one of a swimmer is held, degrees.</summary>
    private const double Thick = 0.75;
    private const double Steepest = 20;

    [Fact]
    public void Heads_over_legs_are_seen_from_behind()
    {
        int heads = 0;
        int seen = 0;
        for (ulong seed = First; seed < First + Count; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            if (creature.Plan is not (BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar))
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double back = double.MinValue;
            for (int ring = StationRing.Shoulder; ring <= StationRing.Pelvis; ring++)
            {
                back = Math.Max(back, shape.Y[ring] + shape.Top[ring]);
            }

            seen += shape.Y[StationRing.Cranium] + shape.Top[StationRing.Cranium] > back ? 1 : 0;
            heads++;
        }

        Assert.InRange(heads, 20, Count);
        Assert.True(seen >= Seen * heads, FormattableString.Invariant($"{seen} of {heads} heads are seen"));
    }

    [Fact]
    public void Half_of_the_head_of_a_sprawler_and_of_a_biped_is_carried_above_the_back()
    {
        int heads = 0;
        int above = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, 1, First, Count))
        {
            if (creature.Plan is BodyPlan.Sprawling or BodyPlan.Theropod && SpeciesCatalogue.Find(creature.Body.Blend.First).Class != AnimalClass.Arthropod)
            {
                double back = Enumerable.Range(StationRing.Shoulder, StationRing.Pelvis + 1 - StationRing.Shoulder).Max(ring => shape.Y[ring] + shape.Top[ring]);
                double height = shape.Top[StationRing.Cranium] + shape.Bottom[StationRing.Cranium];
                heads++;
                above += shape.Y[StationRing.Cranium] + shape.Top[StationRing.Cranium] > back + (0.5 * height) ? 1 : 0;
            }
        }

        Assert.InRange(heads, 20, Count);
        Assert.True(above > 0.88 * heads, FormattableString.Invariant($"{above} of {heads} heads are above the back"));
    }

    [Fact]
    public void No_thick_neck_of_a_mixed_swimmer_is_a_pillar()
    {
        int thick = 0;
        for (ulong seed = First; seed < First + Count; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 1 });
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            bool insect = SpeciesCatalogue.Find(creature.Body.Blend.Bodies[0].Name).Class == AnimalClass.Arthropod;
            if (!insect && creature.Body.Disc.Sweep == 0 && shape.Width[StationRing.NeckMiddle] > Thick * shape.Width[StationRing.Ribs])
            {
                double up = shape.Y[StationRing.Cranium] - shape.Y[StationRing.NeckBase];
                double rise = 180 / Math.PI * Math.Atan2(up, shape.Z[StationRing.Cranium] - shape.Z[StationRing.NeckBase]);
                Assert.True(rise < Steepest, FormattableString.Invariant($"{seed}: a thick neck rises by {rise:0} degrees"));
                thick++;
            }
        }

        Assert.InRange(thick, 8, Count);
    }
}
