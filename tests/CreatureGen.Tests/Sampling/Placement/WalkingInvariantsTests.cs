using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>What holds for every body, over thousands of random ones and every walking plan.</summary>
public sealed class WalkingInvariantsTests
{
    private static readonly BodyPlan[] Plans =
    {
        BodyPlan.Digitigrade, BodyPlan.Unguligrade, BodyPlan.Plantigrade, BodyPlan.Columnar, BodyPlan.Upright, BodyPlan.Sprawling,
        BodyPlan.Theropod, BodyPlan.Hexapod, BodyPlan.ManyLegged, BodyPlan.Legless, BodyPlan.Centaur,
    };

    [Fact]
    public void Legs_never_cross_and_their_sockets_never_share_cells()
    {
        foreach ((SpineMeasure _, SocketSet _, WalkingPlacement placement) in Placements(1))
        {
            var grid = new SocketGrid();
            foreach (LegPlacement leg in placement.Legs)
            {
                Assert.True(grid.TryReserve(leg.Socket, leg.Site.Bounds.Pad));
                foreach (LegPlacement other in placement.Legs)
                {
                    Assert.False(!ReferenceEquals(leg, other) && LegSweep.Crosses(leg, other));
                }
            }

            Assert.True(placement.Arms is null || grid.TryReserve(placement.Arms.Socket, placement.Arms.Site.Bounds.Pad));
        }
    }

    [Fact]
    public void Legs_are_never_tiny_and_reach_from_their_attachment_point_to_the_ground()
    {
        foreach ((SpineMeasure measure, SocketSet set, WalkingPlacement placement) in Placements(2))
        {
            SpineMeasure raised = measure.Raised(placement.RaiseBody);
            Assert.True(placement.RaiseBody <= (set.Stance.MaximumRaise * measure.BodyLength) + 1e-9);
            foreach (LegPlacement leg in placement.Legs)
            {
                Assert.True(leg.Length >= (set.Stance.MinimumLength * measure.BodyLength) - 1e-9);
                Assert.Equal(LegFitting.AttachmentHeight(raised.At(leg.Site.Ring), leg.Site.Segment), leg.Length, 9);
            }
        }
    }

    [Fact]
    public void The_creature_is_balanced_or_says_explicitly_what_it_lacks()
    {
        int balanced = 0;
        int lacking = 0;
        foreach ((SpineMeasure measure, SocketSet set, WalkingPlacement placement) in Placements(3))
        {
            if (placement.Legs.Count == 0)
            {
                Assert.Null(placement.Balance);
                Assert.True(set.Legs.Count == 0 || placement.PlanChange is not null);
                continue;
            }

            var feet = new List<FootContact>();
            double y = 0;
            double z = 0;
            foreach (LegPlacement leg in placement.Legs)
            {
                feet.Add(leg.Foot);
                y += leg.RootHeight / placement.Legs.Count;
                z += leg.RootZ / placement.Legs.Count;
            }

            SagittalPoint mass = Balance.Pitched(measure.Raised(placement.RaiseBody).CentreOfMass, new SagittalPoint(y, z), placement.Balance!.Pitch);
            double margin = Balance.Margin(feet, mass);
            Assert.Equal(margin, placement.Balance.Margin, 6);
            Assert.Equal(placement.Balance.Remedy != BalanceRemedy.AddPairOrTail, margin >= Balance.MinMargin - 1e-9);
            Assert.Equal(placement.Balance.Remedy == BalanceRemedy.AddPairOrTail, placement.Balance.Overhang != 0);
            balanced += margin >= Balance.MinMargin - 1e-9 ? 1 : 0;
            lacking += placement.Balance.Remedy == BalanceRemedy.AddPairOrTail ? 1 : 0;
        }

        Assert.True(balanced > 1000 && lacking > 100);
    }

    [Fact]
    public void The_anatomy_is_complete_or_another_plan_is_named()
    {
        foreach ((SpineMeasure _, SocketSet set, WalkingPlacement placement) in Placements(4))
        {
            Assert.Equal(placement.Legs.Count < set.MinimumPairs, placement.PlanChange is not null);
            Assert.NotEqual(set.Plan, placement.PlanChange);
            for (int i = 1; i < placement.Legs.Count; i++)
            {
                Assert.True(placement.Legs[i].Site.Ring > placement.Legs[i - 1].Site.Ring);
            }
        }
    }

    [Fact]
    public void The_same_body_and_seed_always_give_the_same_limbs()
    {
        var first = new List<(SpineMeasure Measure, SocketSet Set, WalkingPlacement Placement)>(Placements(5));
        int k = 0;
        foreach ((SpineMeasure _, SocketSet _, WalkingPlacement again) in Placements(5))
        {
            WalkingPlacement placement = first[k++].Placement;
            Assert.Equal(placement.Legs, again.Legs);
            Assert.Equal(placement with { Legs = again.Legs }, again);
        }
    }

    [Fact]
    public void Every_number_is_finite()
    {
        foreach ((SpineMeasure _, SocketSet _, WalkingPlacement placement) in Placements(6))
        {
            double sum = placement.RaiseBody;
            foreach (LegPlacement leg in placement.Legs)
            {
                sum += leg.Along + leg.RootZ + leg.RootHeight + leg.RootRadius + leg.Reach + leg.Swing + leg.Shear;
            }

            sum += placement.Arms is null ? 0 : placement.Arms.Length + placement.Arms.RootRadius;
            sum += placement.Balance is null ? 0 : placement.Balance.Shift + placement.Balance.Pitch + placement.Balance.Margin + placement.Balance.Overhang;
            Assert.True(double.IsFinite(sum));
        }
    }

    private static IEnumerable<(SpineMeasure Measure, SocketSet Set, WalkingPlacement Placement)> Placements(ulong seed)
    {
        RandomStream stream = new Seed(seed).Child("bodies").Stream();
        for (int n = 0; n < 330; n++)
        {
            SpineMeasure measure = Spines.Random(stream);
            foreach (BodyPlan plan in Plans)
            {
                SocketSet set = SocketSets.Of(plan);
                var size = new LegSize(stream.Uniform(0.6, 1.5), stream.Uniform(0.6, 1.4), stream.Uniform(0.8, 1.7), stream.Integer(0, 6));
                yield return (measure, set, WalkingRules.Place(measure, set, size, stream));
            }
        }
    }
}
