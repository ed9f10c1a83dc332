using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Fins;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class MidlineFinTests
{
    /// <summary>Part of the base over which its end is looked at: a row of a short fin.</summary>
    private const double Row = 0.125;

    [Theory]
    [InlineData(FinStyle.Carp)]
    [InlineData(FinStyle.Tuna)]
    [InlineData(FinStyle.Ray)]
    public void Fins_whose_rays_are_of_their_own_heights_run_out_behind_and_are_not_cut_off_upright(FinStyle style)
    {
        MidlineFin form = MidlineFin.Of(style)!;
        Assert.True(form.HeightAt(0) <= 0.1);
        Assert.True(form.HeightAt(1) <= 0.05);
        Assert.True(form.HeightAt(1 - Row) < 0.5);
    }

    /// <summary>A fin is low that is less high than this part of its base, and its tip is at most here along its base (1 and more where it leans back as far as a high one).</summary>
    private const double Low = 0.5;
    private const double Foremost = 0.9;

    [Fact]
    public void The_rear_edge_of_a_low_fin_of_a_shark_runs_out_over_the_back_and_is_no_wall()
    {
        int low = 0;
        foreach (int seed in Enumerable.Range(13870001, 160))
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            FinBlueprint? fin = blueprint.Fins.FirstOrDefault(fin => fin.Place == FinPlace.Dorsal);
            if (fin?.Style != FinStyle.Shark)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(blueprint.Plan, blueprint.Body, blueprint.Head, blueprint.Tail);
            (double front, double rear) = (shape.Z[fin.Socket.Ring], shape.Z[fin.Socket.Ring + fin.Socket.Rows]);
            if (fin.Length > Low * (front - rear))
            {
                continue;
            }

            Creature creature = CreatureAssembler.Assemble(blueprint);
            LimbChain limb = creature.Limbs.First(limb => limb.Kind == LimbKind.Dorsal);
            Vector3 root = creature.Skeleton.ModelPositions[limb.Joints[0]];
            Vector3 tip = creature.Skeleton.ModelPositions[limb.Joints[^1]];
            double along = 0.5 + ((root.Z - tip.Z) / (creature.Blueprint.Scale * (front - rear)));
            Assert.True(along < Foremost, FormattableString.Invariant($"{seed}: its tip is at {along:0.00} of its base"));
            low++;
        }

        Assert.InRange(low, 3, 100);
    }

    [Fact]
    public void The_edge_of_a_veil_is_round_and_its_last_ray_less_than_half_as_high_as_the_highest()
    {
        MidlineFin veil = MidlineFin.Of(FinStyle.Veil)!;
        double[] heights = [.. Enumerable.Range(0, 9).Select(i => veil.HeightAt(i / 8.0))];
        Assert.True(heights[8] < 0.5 * heights.Max());
        Assert.True(heights[0] < 0.6 * heights.Max());
        for (int i = 1; i < 8; i++)
        {
            Assert.True(heights[i] > ((heights[i - 1] + heights[i + 1]) / 2) - 0.03, FormattableString.Invariant($"hollow at {i} of 8"));
        }
    }
}
