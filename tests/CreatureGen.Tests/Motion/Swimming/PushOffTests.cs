using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Swimming;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Swimming;

/// <summary>How swimmers leave out of rest, and how they bend into a turn.</summary>
public sealed class PushOffTests
{
    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void A_fish_that_is_to_leave_at_once_curls_its_tail_to_one_side_and_strikes_to_the_other(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            double[] way = Tip(creature, profile, new SwimInput(profile.CruiseSpeed), at => at.X);
            double curl = way.Take(30).MaxBy(Math.Abs);
            double strike = way.Take(60).Max(x => -Math.Sign(curl) * x);
            Assert.True(Math.Abs(curl) > 0.08 && strike > 0.06, FormattableString.Invariant($"{plan} {creature.Blueprint.Seed}: curls by {curl} and strikes by {strike} of its length"));
        }
    }

    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void A_fish_that_leaves_in_a_turn_curls_up_into_it(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            foreach (int side in new[] { 1, -1 })
            {
                Assert.True(Tip(creature, profile, new SwimInput(profile.CruiseSpeed, side * 0.3f), at => at.X).Take(30).Max(x => side * x) > 0.08);
            }
        }
    }

    /// <summary>The more slowly it is to go, the less it bends for it.</summary>
    [Fact]
    public void A_fish_that_is_to_go_slowly_does_not_curl_up_for_it()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Fish))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            Assert.True(Tip(creature, profile, new SwimInput(0.1f * profile.CruiseSpeed), at => at.X).Max(Math.Abs) < 0.05);
        }
    }

    [Fact]
    public void A_whale_raises_its_fluke_and_brings_it_down_as_it_leaves()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Whale).Where(creature => SwimProfile.Of(new MotionSubject(creature)).Style == SwimStyle.Cetacean))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            double[] way = Tip(creature, profile, new SwimInput(profile.CruiseSpeed), at => at.Y);
            double rest = creature.Skeleton.ModelPositions[creature.Skeleton.IndexOf("TailEnd")].Y / profile.BodyLength;
            int top = Array.IndexOf(way, way.Take(30).Max());
            Assert.True(way[top] > rest + 0.07 && way.Skip(top).Take(30).Min() < rest - 0.04, FormattableString.Invariant($"{creature.Blueprint.Seed}: up to {way[top] - rest}, down to {way.Skip(top).Take(30).Min() - rest}"));
        }
    }

    public static TheoryData<string> Rowers => new("plesiosaur", "ray");

    [Theory]
    [MemberData(nameof(Rowers))]
    public void Flippers_and_discs_are_raised_together_and_beat_down_as_the_body_leaves(string species)
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 0, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight(species, 1000)]) };
        Creature creature = CreatureGenerator.Generate(1, options);
        SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
        Assert.True(profile.IsStiff);
        LimbChain limb = creature.Limbs.Where(one => one.Side == Side.Left && one.Kind is LimbKind.Pectoral or LimbKind.Disc).MaxBy(one => creature.Skeleton.ModelPositions[one.Joints[^1]].X)!;
        int left = limb.Joints[^1];
        double[] ways = Points(creature, profile, new SwimInput(profile.CruiseSpeed), model => model.Positions[left].Y);
        double[] mirrored = Points(creature, profile, new SwimInput(profile.CruiseSpeed), model => model.Positions[creature.Skeleton.Mirrors[left]].Y);
        double width = creature.Skeleton.ModelPositions[left].X / profile.BodyLength;
        int top = Array.IndexOf(ways, ways.Take(30).Max());
        Assert.True(ways[top] - ways[0] > 0.1 * width && ways[top] - ways.Skip(top).Take(40).Min() > 0.3 * width, FormattableString.Invariant($"{species}: {ways[0]}, {ways[top]}, {ways.Skip(top).Take(40).Min()} for {width}"));
        Assert.All(ways.Zip(mirrored), pair => Assert.Equal(pair.First, pair.Second, 0.01));
    }

    /// <summary>The front bends first; in a turn that goes on all of the body has the same bend.</summary>
    [Theory]
    [InlineData(BodyPlan.Fish)]
    [InlineData(BodyPlan.Eel)]
    public void A_turn_goes_through_the_body_from_the_head_to_the_tail(BodyPlan plan)
    {
        foreach (Creature creature in StrokeSubject.Of(plan))
        {
            SwimProfile profile = SwimProfile.Of(new MotionSubject(creature));
            var body = new StrokeSubject(creature);
            SwimState state = SwimRun.Steady(profile, new SwimInput(profile.CruiseSpeed), body);
            var turn = new SwimInput(profile.CruiseSpeed, 0.5f);
            SwimRun.Go(profile, turn, ref state, 0.4 / profile.CruiseFrequency, 24, body);
            Assert.True(state.Bend.Value > 1.15 * state.TailBend.Value, $"{plan} {creature.Blueprint.Seed}: {state.Bend.Value} and {state.TailBend.Value}");
            SwimRun.Go(profile, turn, ref state, 8 / profile.CruiseFrequency, 480, body);
            Assert.Equal(state.Bend.Value, state.TailBend.Value, 0.01);
        }
    }

    /// <summary>Where the tip of the tail is in the first beat and a half after two beats of rest, body lengths, 60 to a beat.</summary>
    private static double[] Tip(Creature creature, SwimProfile profile, SwimInput input, Func<Vector3, float> of)
    {
        int tip = creature.Skeleton.IndexOf("TailEnd");
        return Points(creature, profile, input, model => of(model.Positions[tip]));
    }

    private static double[] Points(Creature creature, SwimProfile profile, SwimInput input, Func<Pose, float> of)
    {
        var body = new StrokeSubject(creature);
        SwimState state = default;
        SwimRun.Go(profile, default, ref state, 2 / profile.CruiseFrequency, 120, body);
        var way = new List<double>();
        for (int i = 0; i < 90; i++)
        {
            SwimMotion.Update(profile, input, ref state, 1 / (60 * profile.CruiseFrequency), body.Local);
            body.ToModel();
            way.Add(of(new Pose(body.ModelRotations, body.ModelPositions)) / profile.BodyLength);
            body.AssertWithinLimits("leaving");
        }

        return way.ToArray();
    }
}
