using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class PectoralGrowerTests
{
    /// <summary>Least part of their skin that paired fins show from the side, in the mean of many swimmers; round rods would show more, blades seen on their edges show .23 to .25.</summary>
    private const double Shown = 0.27;

    /// <summary>The same from behind and from the front (.30 where they are turned as far as the eye looks down on them).</summary>
    private const double ShownAhead = 0.35;

    /// <summary>Most that the end of a paired fin is high, in lengths of the fin: sawn-off ones are .044.</summary>
    private const double Thickest = 0.03;

    /// <summary>Greatest mean breadth of paddles over the last fifth of their length, in their greatest: with broader ends they are mittens (.595 before they drew together).</summary>
    private const double BroadestEnd = 0.55;

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void Paired_fins_are_blades_from_the_side_and_not_rods(double strangeness)
    {
        double[] shown = Enumerable.Range(10310001, 24)
            .Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }))
            .SelectMany(creature => creature.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral).Select(limb => Facing(creature.Mesh, limb, Vector3.UnitX)))
            .ToArray();
        Assert.True(shown.Length > 30);
        Assert.True(shown.Average() > Shown, FormattableString.Invariant($"{shown.Average():0.000}"));
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void Paired_fins_on_the_flank_are_blades_from_behind_and_not_rods(double strangeness)
    {
        double[] shown = Enumerable.Range(10310001, 24)
            .Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness }))
            .SelectMany(creature => creature.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral).Select(limb => Facing(creature.Mesh, limb, Vector3.UnitZ)))
            .ToArray();
        Assert.True(shown.Length > 30);
        Assert.True(shown.Average() > ShownAhead, FormattableString.Invariant($"{shown.Average():0.000}"));
    }

    [Fact]
    public void Paired_fins_are_thin_at_their_tips()
    {
        int tips = 0;
        foreach (int seed in Enumerable.Range(10310001, 12))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            foreach (LimbChain fin in creature.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral && limb.Side == Side.Left))
            {
                Vector3 root = creature.Skeleton.ModelPositions[fin.Joints[0]];
                Vector3 axis = creature.Skeleton.ModelPositions[fin.Joints[^1]] - root;
                float length = axis.Length();
                float[] ends = [.. SkinOf(creature.Mesh, fin).Where(p => Vector3.Dot(p - root, axis) > 0.99f * length * length).Select(p => p.Y)];
                Assert.True(ends.Max() - ends.Min() < Thickest * length, FormattableString.Invariant($"{seed}: {(ends.Max() - ends.Min()) / length:0.000}"));
                tips++;
            }
        }

        Assert.True(tips > 6);
    }

    [Fact]
    public void Paddles_draw_together_to_their_tips()
    {
        var ends = new List<double>();
        foreach (int seed in Enumerable.Range(10310001, 60))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (!creature.Blueprint.Fins.All(fin => fin.Place != FinPlace.Pectoral || fin.Style == FinStyle.Paddle))
            {
                continue;
            }

            foreach (LimbChain fin in creature.Limbs.Where(limb => limb.Kind == LimbKind.Pectoral && limb.Side == Side.Left))
            {
                Vector3 root = creature.Skeleton.ModelPositions[fin.Joints[0]];
                Vector3 axis = creature.Skeleton.ModelPositions[fin.Joints[^1]] - root;
                Vector3[] skin = SkinOf(creature.Mesh, fin);
                double end = Breadth(skin, root, axis, 0.8f, 1);
                double greatest = Enumerable.Range(2, 6).Max(tenth => Breadth(skin, root, axis, 0.1f * tenth, 0.1f * (tenth + 1)));
                ends.Add(end / greatest);
            }
        }

        Assert.True(ends.Count > 10);
        Assert.True(ends.Average() < BroadestEnd, FormattableString.Invariant($"{ends.Average():0.000}"));
    }

    /// <summary>How far the points over a stretch of a fin lie apart across its axis.</summary>
    private static double Breadth(Vector3[] skin, Vector3 root, Vector3 axis, float first, float last)
    {
        var across = Vector3.Normalize(Vector3.UnitZ - (axis * (axis.Z / axis.LengthSquared())));
        float[] at = [.. skin.Where(p => Vector3.Dot(p - root, axis) / axis.LengthSquared() is float s && s >= first && s < last).Select(p => Vector3.Dot(p - root, across))];
        return at.Length == 0 ? 0 : at.Max() - at.Min();
    }

    /// <summary>The points of a limb's skin.</summary>
    private static Vector3[] SkinOf(CreatureMesh mesh, LimbChain limb) =>
        [.. Enumerable.Range(0, mesh.Positions.Length).Where(v => limb.Joints.Contains(mesh.Weights[v].Joint0)).Select(v => mesh.Positions[v])];

    /// <summary>The part of a limb's skin that faces along an axis, either way.</summary>
    private static double Facing(CreatureMesh mesh, LimbChain limb, Vector3 axis)
    {
        double area = 0;
        double side = 0;
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            if (Enumerable.Range(t, 3).All(corner => limb.Joints.Contains(mesh.Weights[mesh.Triangles[corner]].Joint0)))
            {
                Vector3 a = mesh.Positions[mesh.Triangles[t]];
                Vector3 cross = Vector3.Cross(mesh.Positions[mesh.Triangles[t + 1]] - a, mesh.Positions[mesh.Triangles[t + 2]] - a);
                area += cross.Length();
                side += Math.Abs(Vector3.Dot(cross, axis));
            }
        }

        return side / area;
    }
}
