using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

public sealed class ArmRulesTests
{
    private static readonly SpineMeasure Body = Spines.Level(new[] { 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2 }, 0.12, 0.8);

    [Fact]
    public void The_nearer_the_first_legs_are_to_the_head_the_rarer_are_arms()
    {
        ArmAnatomy anatomy = EveryRing(0.1, 0.9);
        double before = 0;
        for (int ring = 23; ring <= 43; ring += 2)
        {
            double odds = ArmRules.Odds(Body, anatomy, Legs(ring));
            Assert.InRange(odds, 0.1, 0.9);
            Assert.True(ring == 23 ? odds == 0.1 : odds >= before);
            before = odds;
        }

        Assert.True(before > 0.8);
    }

    [Fact]
    public void Arms_are_decided_at_random_with_those_odds()
    {
        SocketSet set = Spines.EveryBone(Body) with { Legs = new[] { Socket(37) } };
        set = set with { Arms = EveryRing(0.1, 0.7) with { Legs = set.Legs } };
        double odds = ArmRules.Odds(Body, set.Arms!, Legs(37));
        int arms = 0;
        const int Trials = 4000;
        for (ulong seed = 0; seed < Trials; seed++)
        {
            arms += Spines.Place(Body, set, seed).Arms is null ? 0 : 1;
        }

        // Four standard deviations of a binomial count.
        double spread = 4 * System.Math.Sqrt(odds * (1 - odds) / Trials);
        Assert.InRange(arms / (double)Trials, odds - spread, odds + spread);
    }

    [Theory]
    [InlineData(33, 4, 27)]
    [InlineData(39, 7, 30)]
    [InlineData(43, 9, 32)]
    public void Arms_are_placed_midway_between_the_head_and_the_first_used_bone(int legRing, int usedBone, int armRing)
    {
        // The thigh is thicker than half a bone, so it also takes the bone in front of the one that carries it.
        List<LegPlacement> legs = Legs(legRing);
        Assert.Equal(usedBone, ArmRules.FirstUsedBone(Body, legs));
        Assert.Equal(armRing, ArmRules.Place(Body, EveryRing(1, 1), LegSize.Nominal, legs)!.Site.Ring);
    }

    [Fact]
    public void Arms_take_the_nearest_place_of_the_anatomy()
    {
        ArmAnatomy anatomy = EveryRing(1, 1) with { Sockets = new[] { Socket(24) with { Archetype = LimbArchetype.Arm }, Socket(29) with { Archetype = LimbArchetype.Arm } } };
        Assert.Equal(29, ArmRules.Place(Body, anatomy, LegSize.Nominal, Legs(39))!.Site.Ring);
        Assert.Equal(24, ArmRules.Place(Body, anatomy, LegSize.Nominal, Legs(31))!.Site.Ring);
    }

    [Fact]
    public void Arms_that_would_cross_the_first_legs_are_left_out() =>
        Assert.Null(ArmRules.Place(Body, EveryRing(1, 1), LegSize.Nominal, Legs(24)));

    [Fact]
    public void Arms_never_reach_the_ground()
    {
        foreach (double height in new[] { 0.2, 0.5, 1, 2 })
        {
            SpineMeasure body = Body.Raised(height - 0.8);
            ArmPlacement arms = ArmRules.Place(body, EveryRing(1, 1), LegSize.Nominal, Legs(43))!;
            Assert.True(arms.Length > 0);
            Assert.True(arms.Length < LegFitting.AttachmentHeight(body.At(arms.Site.Ring), arms.Site.Segment));
        }

        Assert.Null(ArmRules.Place(Body.Raised(-1), EveryRing(1, 1), LegSize.Nominal, Legs(43)));
    }

    [Fact]
    public void Forelegs_make_room_for_arms()
    {
        WalkingPlacement centaur = Spines.Place(BaseBodySpines.Measure("canine", 0.9), SocketSets.Centaur(BodyPlan.Digitigrade));
        Assert.Equal(23, centaur.Arms!.Site.Ring);
        Assert.Equal(new[] { 30, 41 }, Rings(centaur));

        SocketSet beetle = SocketSets.Hexapod();
        WalkingPlacement armed = Spines.Place(BaseBodySpines.Measure("insect", 0.3), beetle with { Arms = beetle.Arms! with { OddsNear = 1, OddsFar = 1 } });
        Assert.Equal(22, armed.Arms!.Site.Ring);
        Assert.Equal(new[] { 26, 30, 33 }, Rings(armed));
    }

    private static int[] Rings(WalkingPlacement placement)
    {
        int[] rings = new int[placement.Legs.Count];
        for (int i = 0; i < rings.Length; i++)
        {
            rings[i] = placement.Legs[i].Site.Ring;
        }

        return rings;
    }

    private static List<LegPlacement> Legs(int ring) => new() { LegFitting.Stand(Body, Socket(ring), LegSize.Nominal, LegGirth.Min) };

    private static LimbSocket Socket(int ring) => new(ring, 8, LimbArchetype.Theropod, 0.2, 0, 0, SocketBounds.Insect);

    private static ArmAnatomy EveryRing(double near, double far)
    {
        var sockets = new List<LimbSocket>();
        for (int ring = 22; ring <= 44; ring++)
        {
            sockets.Add(Socket(ring) with { Archetype = LimbArchetype.Arm });
        }

        return new ArmAnatomy(sockets, new[] { Socket(39) }, near, far, 0.4);
    }
}
