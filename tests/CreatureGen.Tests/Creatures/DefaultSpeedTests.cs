using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class DefaultSpeedTests
{
    [Theory]
    [InlineData(BodyPlan.Fish, "Swim")]
    [InlineData(BodyPlan.Eel, "Swim", Explicit = true)]
    [InlineData(BodyPlan.Whale, "Swim", Explicit = true)]
    [InlineData(BodyPlan.Flipper, "Swim", Explicit = true)]
    [InlineData(BodyPlan.Flapping, "Fly")]
    [InlineData(BodyPlan.Buzzing, "Fly", Explicit = true)]
    [InlineData(BodyPlan.Legless, "Slither")]
    public void What_does_not_walk_cruises_at_its_default_speed(BodyPlan plan, string movement)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            Movement cruise = Movement.Of(new MotionProfile(creature)).Single(item => item.Name == movement);
            Assert.Equal(creature.DefaultSpeed, cruise.Input.Speed, 1e-4f);
        }
    }

    /// <summary>Dynamic similarity: v² = Fr·g·ℓ, with Fr of a quiet walk and the twelve hundredths by which individuals differ.</summary>
    [Fact]
    public void Walkers_of_all_sizes_walk_at_one_Froude_number()
    {
        for (ulong seed = 0; seed < 12; seed++)
        {
            double scale = seed % 2 == 0 ? 0.3 : 4;
            Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, MinScale = scale, MaxScale = scale, MinLegPairs = 2 });
            double hips = creature.Limbs.Where(l => l.Kind == LimbKind.Leg && l.Stands).Max(l => creature.Skeleton.Joints[l.Joints[1]].ModelPosition.Y);
            Assert.InRange(creature.DefaultSpeed / Math.Sqrt(0.12 * 9.80665 * hips), 0.87, 1.13);
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void Individuals_of_a_species_have_paces_of_their_own(RequestedKind kind)
    {
        // Of one size: with nothing else that differs, speeds would be the same to a few hundredths.
        double[] paces = Enumerable.Range(0, 12).Select(individual =>
        {
            Creature creature = CreatureGenerator.Generate(77, CreatureOptions.Default with { Kind = kind, MinScale = 1, MaxScale = 1, Individual = (ulong)individual });
            return creature.DefaultSpeed / Math.Sqrt(creature.StandingHeight);
        }).ToArray();
        Assert.Equal(paces.Length, paces.Distinct().Count());
        Assert.True(paces.Max() > 1.06 * paces.Min(), $"{paces.Min()} to {paces.Max()}");
        Assert.True(paces.Max() < 1.6 * paces.Min(), $"{paces.Min()} to {paces.Max()}");
    }
}
