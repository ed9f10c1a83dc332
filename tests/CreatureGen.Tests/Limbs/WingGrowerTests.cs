using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class WingGrowerTests
{
    /// <summary>Least way of a tip behind its shoulder, in spans; wings of .05 to .25 of sweep were caps on the shoulders from the side.</summary>
    private const float Behind = 0.03f;

    [Fact]
    public void Spread_wings_rise_to_their_tips_and_lie_back_so_that_they_are_seen_from_the_side()
    {
        int wings = 0;
        foreach (int seed in Enumerable.Range(16080000, 24))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (creature.Blueprint.Wings.Count == 0 || creature.Blueprint.Wings.Any(wing => wing.Style == WingStyle.Folded))
            {
                continue;
            }

            foreach (LimbChain wing in creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing && limb.Side == Side.Left))
            {
                Vector3[] bones = [.. wing.Joints.Select(joint => creature.Skeleton.ModelPositions[joint])];
                float span = Vector3.Distance(bones[0], bones[^1]);
                Assert.True(bones[0].Z - bones[^1].Z > Behind * span, FormattableString.Invariant($"{seed}: the tip lies {(bones[0].Z - bones[^1].Z) / span} of the span behind"));
                Assert.True(bones[^1].Y >= bones.Max(bone => bone.Y) - 1e-3f, FormattableString.Invariant($"{seed}: the tip hangs"));
                wings++;
            }
        }

        Assert.True(wings > 8);
    }

    /// <summary>Least height of the skin near the root of a wing, in its greatest depth: level blades were rods from the front.</summary>
    private const float RootHeight = 0.33f;

    [Fact]
    public void Roots_of_spread_wings_are_seen_from_the_front_as_a_third_of_their_depth()
    {
        var heights = new List<float>();
        foreach (int seed in Enumerable.Range(22215000, 30))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (creature.Blueprint.Wings.Count == 0 || creature.Blueprint.Wings.Any(wing => wing.Style == WingStyle.Folded))
            {
                continue;
            }

            LimbChain wing = creature.Limbs.First(limb => limb.Kind == LimbKind.Wing && limb.Side == Side.Left);
            float shoulder = creature.Skeleton.ModelPositions[wing.Joints[0]].X;
            float span = creature.Skeleton.ModelPositions[wing.Joints[^1]].X - shoulder;
            Vector3[] root = [.. Enumerable.Range(0, creature.Mesh.Positions.Length)
                .Where(v => wing.Joints.Contains(creature.Mesh.Weights[v].Joint0))
                .Select(v => creature.Mesh.Positions[v])
                .Where(p => p.X > shoulder + (0.1f * span) && p.X < shoulder + (0.22f * span))];
            heights.Add((root.Max(p => p.Y) - root.Min(p => p.Y)) / (float)(creature.Blueprint.Wings[0].Chord * creature.Blueprint.Scale));
        }

        Assert.True(heights.Count > 8);
        Assert.True(heights.Average() > RootHeight, FormattableString.Invariant($"{heights.Average()} of the depth, {heights.Min()} at the least"));
    }

    /// <summary>Height of a wing where it leaves the trunk, in heights of the trunk there, in the mean (.34 where it was a rod plugged into the trunk).</summary>
    private const double Shoulder = 0.4;

    [Fact]
    public void Wings_leave_the_trunk_with_a_shoulder()
    {
        var heights = new List<double>();
        foreach (int seed in Enumerable.Range(24831000, 30))
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (blueprint.Wings.Count != 1)
            {
                continue;
            }

            Surface surface = RigSubject.InputOf(blueprint).Surface;
            int ring = blueprint.Wings[0].Socket.Ring + (blueprint.Wings[0].Socket.Rows / 2);
            double trunk = Height(surface, at => at.Region == SurfaceRegion.Body && at.Ring == ring);
            heights.Add(Height(surface, at => at.Region == SurfaceRegion.Wing && at.Along > 0.06f && at.Along < 0.12f) / trunk);
        }

        Assert.True(heights.Count > 15);
        Assert.True(heights.Average() > Shoulder, FormattableString.Invariant($"{heights.Average()} of the trunk, {heights.Min()} at the least"));
    }

    private static double Height(Surface surface, Func<VertexAddress, bool> of)
    {
        float[] heights = [.. Enumerable.Range(0, surface.Positions.Length).Where(v => of(surface.Addresses[v])).Select(v => surface.Positions[v].Y)];
        return heights.Max() - heights.Min();
    }

    /// <summary>Greatest extent of the end of a feathered wing, in its greatest depth (.13 and more of nine of 21 whose outermost feather was cut off).</summary>
    private const double Tip = 0.12;

    [Fact]
    public void Feathered_wings_run_out_into_a_tip()
    {
        int wings = 0;
        foreach (int seed in Enumerable.Range(24831000, 30))
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            WingBlueprint? wing = blueprint.Wings.FirstOrDefault(w => w.Style != WingStyle.Folded && WingForm.Of(w.Style).Feathers > 0);
            if (wing == null)
            {
                continue;
            }

            Surface surface = RigSubject.InputOf(blueprint).Surface;
            Vector3[] end = [.. Enumerable.Range(0, surface.Positions.Length).Where(v => surface.Addresses[v] is var at && at.Region == SurfaceRegion.Wing && at.Along == 1f && at.Sign > 0).Select(v => surface.Positions[v])];
            Assert.All(end, p => Assert.InRange(Vector3.Distance(p, end[0]), 0, Tip * wing.Chord));
            wings++;
        }

        Assert.True(wings > 3);
    }
}
