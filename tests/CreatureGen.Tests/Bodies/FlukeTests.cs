using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Bodies;

public sealed class FlukeTests
{
    private const int Last = BodyGrid.Rings - 1;

    /// <summary>Longest fluke along the spine, in half of its span: those of dolphins are as long as half a span.</summary>
    private const double Longest = 1.2;

    [Fact]
    public void Flukes_are_no_longer_than_half_their_span_and_end_in_points_at_their_rear_edge()
    {
        int flukes = 0;
        for (ulong seed = 10440001; seed <= 10440150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            if (creature.Tail.Style != TailStyle.Fluke)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            Assert.True(shape.Width[Last - 1] < 0.99 * shape.Width[Last], FormattableString.Invariant($"{seed}: a fluke with cut tips"));
            double behind = 0;
            for (int i = Last; i > StationRing.TailFirst; i--)
            {
                Assert.True(behind < Longest * creature.Tail.Size || shape.Width[i] <= shape.Width[StationRing.TailFirst] + 1e-9, FormattableString.Invariant($"{seed}: a funnel instead of a fluke"));
                behind += shape.Step[i];
            }

            flukes++;
        }

        Assert.True(flukes > 3);
    }

    /// <summary>Least that the tips of a fluke are above its middle, in half of its span: a level one is a thread from the side.</summary>
    private const double Bent = 0.27;

    [Fact]
    public void The_tips_of_a_fluke_are_bent_up()
    {
        int flukes = 0;
        for (ulong seed = 10440001; seed <= 10440150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            if (creature.Tail.Style == TailStyle.Fluke)
            {
                BodySkin skin = BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature);
                float bent = System.Numerics.Vector3.Dot(skin[Last, BodyGrid.Segments / 4] - skin.Shape.Centre(Last), skin.Shape.Up(Last));
                Assert.True(bent > Bent * creature.Tail.Size, FormattableString.Invariant($"{seed}: tips {bent / creature.Tail.Size:0.00} half spans above the middle"));
                flukes++;
            }
        }

        Assert.True(flukes > 3);
    }

    /// <summary>Part of the rise of a lobe that its first and its last eighth may have: a tip that points up is a horn from ahead.</summary>
    private const double LevelTip = 0.08;

    [Fact]
    public void A_fluke_has_rays_and_its_lobes_rise_between_a_level_root_and_a_level_tip()
    {
        int flukes = 0;
        for (ulong seed = 24840000; seed < 24840024; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            if (creature.Tail.Style != TailStyle.Fluke)
            {
                continue;
            }

            BodySkin skin = BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature);
            double Thickness(int segment) => System.Numerics.Vector3.Dot(skin[Last - 1, segment] - skin[Last - 1, (BodyGrid.Segments / 2) - segment], skin.Shape.Up(Last - 1));
            Assert.True(Thickness(3) < (Thickness(2) + Thickness(4)) / 2, FormattableString.Invariant($"{seed}: between two rays {Thickness(3)} m thick, on them {Thickness(2)} and {Thickness(4)}"));
            flukes++;
        }

        Assert.True(flukes > 3);
        Assert.True(FlukeTail.RiseAt(1) - FlukeTail.RiseAt(0.875) < LevelTip * FlukeTail.RiseAt(1));
        Assert.True(FlukeTail.RiseAt(0.125) < LevelTip * FlukeTail.RiseAt(1));
    }

    /// <summary>Where the faces of a lobe cut through one another they are smoothed until they do not: its tip was cut off square.</summary>
    [Theory]
    [InlineData(24250029)]
    [InlineData(24250021)]
    [InlineData(24250002)]
    public void A_fluke_keeps_its_tips_as_it_is_grown(ulong seed)
    {
        CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
        Assert.Equal(TailStyle.Fluke, blueprint.Tail.Style);
        Creature creature = CreatureAssembler.Assemble(blueprint);
        BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
        double tip = shape.Width[Last] * blueprint.Scale;
        double grown = creature.Mesh.Positions.ToArray().Where((_, v) => creature.Skeleton.Joints[creature.Mesh.Weights[v].Joint0].Role is JointRole.Tail or JointRole.Spine).Max(p => Math.Abs(p.X));
        Assert.True(grown > 0.97 * tip, FormattableString.Invariant($"{seed}: tips {grown} m out, {tip} as they are shaped"));
    }

    [Fact]
    public void The_rear_edge_of_a_fluke_is_full_beside_its_notch_and_hollow_before_its_tips()
    {
        // Against the straight line from the notch to the tip.
        double Fullness(double across) => FlukeTail.EdgeAt(across) - (FlukeTail.EdgeAt(0) * (1 - across)) - across;
        Assert.True(Fullness(0.2) > 0.15);
        Assert.True(Fullness(0.85) < -0.05);
        Assert.True(FlukeTail.EdgeAt(0) < -0.1);
        Assert.Equal(1, FlukeTail.EdgeAt(1), 12);
        for (int i = 1; i <= 100; i++)
        {
            Assert.True(FlukeTail.EdgeAt(i / 100.0) > FlukeTail.EdgeAt((i - 1) / 100.0));
        }
    }
}
