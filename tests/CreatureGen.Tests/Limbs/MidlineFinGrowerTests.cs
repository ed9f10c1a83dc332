using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class MidlineFinGrowerTests
{
    /// <summary>Most that the top of a shark's fin on the back is long, relative to the fin: level ones are .17.</summary>
    private const double Point = 0.12;

    [Fact]
    public void The_fin_of_a_shark_on_the_back_runs_out_in_a_point()
    {
        int fins = 0;
        foreach (ulong seed in Enumerable.Range(10310001, 60).Select(k => (ulong)k))
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            FinBlueprint[] back = [.. blueprint.Fins.Where(fin => fin.Place == FinPlace.Dorsal)];
            if (back.Length != 1 || back[0].Style != FinStyle.Shark)
            {
                continue;
            }

            Creature creature = CreatureAssembler.Assemble(blueprint);
            LimbChain fin = creature.Limbs.Single(limb => limb.Kind == LimbKind.Dorsal);
            Vector3 root = creature.Skeleton.ModelPositions[fin.Joints[0]];
            Vector3 axis = creature.Skeleton.ModelPositions[fin.Joints[^1]] - root;
            Vector3[] skin = [.. Enumerable.Range(0, creature.Mesh.Positions.Length).Where(v => fin.Joints.Contains(creature.Mesh.Weights[v].Joint0)).Select(v => creature.Mesh.Positions[v])];
            float height = skin.Max(p => p.Y);
            float[] top = [.. skin.Where(p => p.Y > height - (0.05f * axis.Y)).Select(p => p.Z)];
            float length = skin.Max(p => p.Z) - skin.Min(p => p.Z);
            Assert.True(top.Max() - top.Min() < Point * length, FormattableString.Invariant($"{seed}: {(top.Max() - top.Min()) / length:0.000}"));
            fins++;
        }

        Assert.True(fins > 1);
    }
}
