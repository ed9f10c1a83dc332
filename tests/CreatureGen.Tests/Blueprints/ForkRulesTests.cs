using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Repairs;
using CreatureGen.Tests.Creatures.Forks;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class ForkRulesTests
{
    private static CreatureBlueprint Forked { get; } = ForkedCreatures.Of(LocomotionKind.Walking, 8).First(pair => pair.One.Legs.Count > 0 && pair.One.Features.Count > 0).Two;

    [Fact]
    public void A_body_forks_in_front_of_its_limbs_or_is_refused_with_the_ring_of_the_first()
    {
        int first = Forked.Legs.Min(leg => leg.Socket.Ring);
        CreatureBlueprint late = Forked with { Legs = Forked.Legs.Each(leg => leg.Socket.Ring == first ? leg with { Socket = leg.Socket with { Ring = Forked.Fork!.Ring } } : leg) };
        Problem problem = Assert.Single(BlueprintValidator.Validate(late), one => one.Path == "fork.ring");
        Assert.Contains("in front of all limbs", problem.Expectation);
        Assert.Contains(Forked.Fork!.Ring.ToString(System.Globalization.CultureInfo.InvariantCulture), problem.Expectation);
    }

    [Fact]
    public void What_is_as_wide_as_wings_or_has_ears_or_feelers_on_its_neck_does_not_fork()
    {
        Assert.Contains(BlueprintValidator.Validate(Forked with { Body = Forked.Body with { Disc = new DiscBlueprint(0.2, 0) } }), one => one.Path == "fork");
        EarBlueprint ear = LimbFields.Ear.Neutral with { Socket = LimbFields.Ear.Neutral.Socket with { Ring = 17 } };
        Assert.Contains(BlueprintValidator.Validate(Forked with { Ears = new ValueList<EarBlueprint>(new[] { ear }) }), one => one.Path == "ears[0].socket");
        FeatureBlueprint feeler = Forked.Features[0] with { Kind = FeatureKind.Antenna, Ring = 18, Segment = 4 };
        Assert.Contains(BlueprintValidator.Validate(Forked with { Features = new ValueList<FeatureBlueprint>(new[] { feeler }) }), one => one.Path == "features[0].ring");
    }

    [Fact]
    public void A_repair_takes_back_a_fork_that_limbs_are_in_the_way_of()
    {
        RepairReport report = BlueprintRepair.Repair(Forked with { Fork = Forked.Fork! with { Ring = 26 } });
        Assert.True(report.IsSound);
        Assert.Null(report.Blueprint.Fork);
        Assert.Equal(Forked.Legs, report.Blueprint.Legs);
    }
}
