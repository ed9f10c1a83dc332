using System;
using System.Linq;
using System.Numerics;
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

    // Least part of what a lobe covers from above that its upper face shows in the mean: the near one from behind, from ahead and from the side, and the far one from behind. Level lobes show .47, .37, .51 and .38, lobes bent up by .36 of half a span .27, .30, .24 and .48.
    private const double NearFromBehind = 0.5;
    private const double NearFromAhead = 0.4;
    private const double NearFromTheSide = 0.6;
    private const double FarFromBehind = 0.25;

    // Degrees from ahead of the views, and above the level of all; and from where on the blade is measured, in half spans.
    private const double Behind = 157;
    private const double Ahead = 38;
    private const double Side = 90;
    private const double Above = 14;
    private const double BladeFirst = 0.3;

    [Fact]
    public void Lobes_of_a_fluke_show_their_upper_face_from_behind_and_the_near_one_from_ahead_and_from_the_side()
    {
        BodySkin[] flukes = Enumerable.Range(0, 60)
            .Select(i => BlueprintSampler.Sample(24940000 + (ulong)i, LocomotionKind.Swimming))
            .Where(creature => creature.Tail.Style == TailStyle.Fluke)
            .Select(creature => BodySkin.Span(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail), creature))
            .ToArray();
        Assert.True(flukes.Length > 10);
        (string View, int Lobe, double Degrees, double Least)[] claims =
        {
            ("near from behind", 1, Behind, NearFromBehind), ("far from behind", -1, Behind, FarFromBehind), ("near from ahead", 1, Ahead, NearFromAhead), ("near from the side", 1, Side, NearFromTheSide),
        };
        Assert.All(claims, claim =>
        {
            double shown = flukes.Average(skin => Shown(skin, claim.Lobe, claim.Degrees));
            Assert.True(shown > claim.Least, FormattableString.Invariant($"the lobe {claim.View} shows {shown:0.000} of itself"));
        });
    }

    /// <summary>What the upper face of one lobe shows from a side, as a part of what it shows from above.</summary>
    private static double Shown(BodySkin skin, int lobe, double degrees)
    {
        (double beside, double above) = (degrees * Math.PI / 180, Above * Math.PI / 180);
        var view = new Vector3((float)(Math.Sin(beside) * Math.Cos(above)), (float)Math.Sin(above), (float)(Math.Cos(beside) * Math.Cos(above)));
        (double seen, double whole) = (0, 0);
        for (int i = StationRing.TailFirst; i < Last; i++)
        {
            for (int j = 0; j < BodyGrid.Segments; j++)
            {
                int k = (j + 1) % BodyGrid.Segments;
                Vector3 area = Vector3.Cross(skin[i, k] - skin[i + 1, j], skin[i + 1, k] - skin[i, j]) / 2;
                float across = lobe * (skin[i, j].X + skin[i, k].X + skin[i + 1, j].X + skin[i + 1, k].X) / 4;
                double up = Vector3.Dot(area, skin.Shape.Up(i));
                if (up > 0 && across > BladeFirst * skin.Shape.Width[Last])
                {
                    whole += up;
                    seen += Math.Max(0, Vector3.Dot(area, view));
                }
            }
        }

        return seen / whole;
    }

    /// <summary>Part of the fall of a lobe that its first and its last eighth may have: a tip that points up or down is a horn from ahead.</summary>
    private const double LevelTip = 0.08;

    [Fact]
    public void A_fluke_has_rays_and_its_lobes_droop_between_a_level_root_and_a_level_tip()
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
            double Thickness(int segment) => Vector3.Dot(skin[Last - 1, segment] - skin[Last - 1, (BodyGrid.Segments / 2) - segment], skin.Shape.Up(Last - 1));
            Assert.True(Thickness(3) < (Thickness(2) + Thickness(4)) / 2, FormattableString.Invariant($"{seed}: between two rays {Thickness(3)} m thick, on them {Thickness(2)} and {Thickness(4)}"));
            flukes++;
        }

        Assert.True(flukes > 3);
        Assert.True(FlukeTail.FallAt(1) - FlukeTail.FallAt(0.875) < LevelTip * FlukeTail.FallAt(1));
        Assert.True(FlukeTail.FallAt(0.125) < LevelTip * FlukeTail.FallAt(1));
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
