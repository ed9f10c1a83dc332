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

public sealed class FoldedWingGrowerTests
{
    private const int First = 15031000;
    private const int Count = 60;

    /// <summary>Most by which folded wings are broader than the trunk between them, in half widths of it, in the mean of many birds (.30 where both edges stand off).</summary>
    private const double Broadest = 0.2;

    [Fact]
    public void Folded_wings_lie_on_the_flanks_and_do_not_stand_off_as_shells()
    {
        var broader = new List<double>();
        foreach (int seed in Enumerable.Range(First, Count))
        {
            Creature creature = CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            if (!creature.Blueprint.Wings.Any(wing => wing.Style == WingStyle.Folded))
            {
                continue;
            }

            int[] limbs = [.. creature.Limbs.SelectMany(limb => limb.Joints)];
            int[] wings = [.. creature.Limbs.Where(limb => limb.Kind == LimbKind.Wing).SelectMany(limb => limb.Joints)];
            Vector3[] wing = Skin(creature.Mesh, joint => wings.Contains(joint));
            (float rear, float front) = (wing.Min(p => p.Z), wing.Max(p => p.Z));
            float trunk = Skin(creature.Mesh, joint => !limbs.Contains(joint)).Where(p => p.Z > rear && p.Z < front).Max(p => Math.Abs(p.X));
            broader.Add((wing.Max(p => Math.Abs(p.X)) / trunk) - 1);
        }

        Assert.True(broader.Count >= 4, $"{broader.Count} birds");
        Assert.True(broader.Average() < Broadest, FormattableString.Invariant($"{broader.Average():0.000} of {broader.Count}"));
    }

    private static Vector3[] Skin(CreatureMesh mesh, Func<int, bool> of) =>
        [.. Enumerable.Range(0, mesh.Positions.Length).Where(v => of(mesh.Weights[v].Joint0)).Select(v => mesh.Positions[v])];
}
