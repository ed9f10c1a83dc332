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
using CreatureGen.Skinning;
using Xunit;
using static CreatureGen.Tests.Motion.Swimming.SwimRun;

namespace CreatureGen.Tests.Motion.Swimming;

/// <summary>Rays, which beat the halves of their disc.</summary>
public sealed class RayTests
{
    private static readonly CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 0, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight("ray", 1000)]) };

    public static IEnumerable<TheoryDataRow<ulong>> Seeds => Enumerable.Range(1, 5).Select(seed => new TheoryDataRow<ulong>((ulong)seed) { Explicit = seed > 2 });

    [Theory]
    [MemberData(nameof(Seeds))]
    public void A_disc_has_three_rows_of_joints_from_trunk_to_edge_on_each_side(ulong seed)
    {
        Creature ray = CreatureGenerator.Generate(seed, options);
        LimbChain[] rows = ray.Limbs.Where(limb => limb.Kind == LimbKind.Disc && limb.Side == Side.Left).ToArray();
        Assert.Equal(3, rows.Length);
        Assert.Equal(3, ray.Limbs.Count(limb => limb.Kind == LimbKind.Disc && limb.Side == Side.Right));
        foreach (LimbChain row in rows)
        {
            float[] outward = row.Joints.Select(joint => ray.Skeleton.ModelPositions[joint].X).ToArray();
            Assert.True(outward[0] > 0f && outward[1] > outward[0] && outward[2] > outward[1], $"{seed}: {string.Join(", ", outward)}");
            Assert.All(row.Joints.Take(2), joint => Assert.Contains(ray.Mesh.Weights.ToArray(), weights => weights.Joint0 == joint && weights.Weights.X > 0.3f));
        }

        Assert.True(rows.Zip(rows.Skip(1)).All(pair => ray.Skeleton.ModelPositions[pair.First.Joints[0]].Z > ray.Skeleton.ModelPositions[pair.Second.Joints[0]].Z));
    }

    /// <summary>The halves of a disc are its paired fins: those of another species, held by the trunk, stayed at the edge's place as it beat, and drew it down like the legs of a table.</summary>
    [Theory]
    [InlineData(24890016)]
    public void Paired_fins_of_another_species_do_not_grow_from_the_edge_of_a_disc(int seed)
    {
        Creature ray = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
        float edge = ray.Limbs.Where(limb => limb.Kind == LimbKind.Disc && limb.Side == Side.Left).Max(limb => ray.Skeleton.ModelPositions[limb.Joints[^1]].X);
        Assert.All(ray.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral && limb.Side == Side.Left), fin => Assert.True(ray.Skeleton.ModelPositions[fin.Joints[0]].X < 0.4f * edge, $"{fin.Pair}"));
        Assert.Equal(SwimStyle.Disc, SwimProfile.Of(new MotionSubject(ray)).Style);
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void The_edge_beats_up_and_down_in_a_wave_from_front_to_rear_and_alike_on_both_sides(ulong seed)
    {
        Creature ray = CreatureGenerator.Generate(seed, options);
        var body = new StrokeSubject(ray);
        SwimProfile profile = SwimProfile.Of(new MotionSubject(ray));
        Assert.Equal(SwimStyle.Disc, profile.Style);
        SwimState state = Steady(profile, new SwimInput(profile.CruiseSpeed), body);
        LimbChain[] rows = ray.Limbs.Where(limb => limb.Kind == LimbKind.Disc && limb.Side == Side.Left).ToArray();
        var heights = rows.Select(_ => new List<float>()).ToArray();
        var model = new Pose(new Quaternion[ray.Skeleton.Count], new Vector3[ray.Skeleton.Count]);
        const int Steps = 60;
        for (int i = 0; i < Steps; i++)
        {
            SwimMotion.Update(profile, new SwimInput(profile.CruiseSpeed), ref state, 1 / (Steps * profile.CruiseFrequency), body.Local);
            ForwardKinematics.LocalToModel(ray.Skeleton, body.Local, model);
            for (int row = 0; row < rows.Length; row++)
            {
                int edge = rows[row].Joints[2];
                Vector3 left = model.Positions[edge];
                Vector3 right = model.Positions[ray.Skeleton.Mirrors[edge]];
                Assert.True(Math.Abs(left.Y - right.Y) < 0.01f * profile.BodyLength, $"{seed}: {left} and {right}");
                heights[row].Add(left.Y);
            }
        }

        int[] tops = heights.Select(row => row.IndexOf(row.Max())).ToArray();
        for (int row = 0; row < rows.Length; row++)
        {
            float way = heights[row].Max() - heights[row].Min();
            float width = ray.Skeleton.ModelPositions[rows[row].Joints[2]].X;
            Assert.True(way > 0.5f * width, $"{seed}: row {row} goes {way} m up and down, its half is {width} m wide");
            int later = row == 0 ? 1 : ((tops[row] - tops[row - 1]) % Steps + Steps) % Steps;
            Assert.True(later is > 0 and < Steps / 3, $"{seed}: row {row} is {later} of {Steps} steps behind the one before it");
        }
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void Joints_of_the_disc_stay_within_their_limits_whatever_is_asked(ulong seed)
    {
        Creature ray = CreatureGenerator.Generate(seed, options);
        var body = new StrokeSubject(ray);
        SwimProfile profile = SwimProfile.Of(new MotionSubject(ray));
        var state = default(SwimState);
        for (int i = 0; i < 600; i++)
        {
            SwimMotion.Update(profile, Wild(profile, i / 60.0), ref state, 1 / (30 * profile.CruiseFrequency), body.Local);
            body.AssertWithinLimits(FormattableString.Invariant($"ray {seed} step {i}"));
        }
    }
}
