using System;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class SweepThroughAirTests
{
    /// <summary>Who calls throws its trunk up over feet that stand.</summary>
    [Fact]
    public void A_foot_that_stands_sweeps_about_its_hip_but_not_through_the_air()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        Clip call = ClipBaker.BakeActs(creature).Single(clip => clip.Name == "Call");
        AngularRule through = AngularRules.Whoosh with { ThresholdPower = 1.7, ThresholdFraction = 0f };
        AngularRule about = through with { Sweep = AngularSweep.AnyWay with { Ends = through.Sweep!.Ends } };
        Assert.Contains(AngularEventDetector.Find(call, creature.Skeleton, about).Events, IsOfLeg);
        Assert.DoesNotContain(AngularEventDetector.Find(call, creature.Skeleton, through).Events, IsOfLeg);
    }

    [Fact]
    public void What_sweeps_through_the_air_is_never_faster_than_about_where_it_begins()
    {
        Creature creature = SpeciesSubject.Of("feline", RequestedKind.Walking);
        AngularRule through = AngularRules.Whoosh;
        AngularRule about = through with { Sweep = AngularSweep.AnyWay with { Ends = through.Sweep!.Ends } };
        foreach (Clip clip in ClipBaker.BakeActs(creature))
        {
            var slower = AngularEventDetector.Find(clip, creature.Skeleton, through).Curves;
            var faster = AngularEventDetector.Find(clip, creature.Skeleton, about).Curves;
            Assert.Equal(faster.Count, slower.Count);
            Assert.All(slower.Zip(faster), pair => Assert.All(pair.First.Speeds.ToArray().Zip(pair.Second.Speeds.ToArray()), speed => Assert.True(speed.First <= speed.Second)));
        }
    }

    private static bool IsOfLeg(ClipEvent one) => one.Joint.StartsWith("Leg_", StringComparison.Ordinal);
}
