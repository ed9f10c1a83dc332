using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Limbs;

public sealed class EarGrowerTests
{
    /// <summary>Least skin of ears that faces the side, in what faces ahead and behind, in the mean of many walkers: leaves that face straight ahead are pegs from the side (.33).</summary>
    private const double FromTheSide = 0.6;

    /// <summary>The same the other way round: leaves that face the side are pegs from the front.</summary>
    private const double FromTheFront = 0.9;

    [Fact]
    public void Upright_ears_are_leaves_from_the_side_and_from_the_front()
    {
        var ears = Enumerable.Range(22259000, 40)
            .Select(seed => CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Walking }))
            .Where(creature => creature.Blueprint.Ears.Any(ear => ear.Upward > ear.Outward))
            .SelectMany(creature => creature.Limbs.Where(limb => limb.Kind == LimbKind.Ear && limb.Side == Side.Left).Select(limb => (Creature: creature, Limb: limb)))
            .Select(ear => (Side: Facing(ear.Creature.Mesh, ear.Limb, Vector3.UnitX), Front: Facing(ear.Creature.Mesh, ear.Limb, Vector3.UnitZ)))
            .ToArray();
        Assert.True(ears.Length > 8, $"{ears.Length} ears");
        double side = ears.Average(ear => ear.Side / ear.Front);
        double front = ears.Average(ear => ear.Front / ear.Side);
        Assert.True(side > FromTheSide && front > FromTheFront, FormattableString.Invariant($"{side:0.000} from the side, {front:0.000} from the front"));
    }

    /// <summary>Area of a limb's skin as it is seen along an axis.</summary>
    private static double Facing(CreatureMesh mesh, LimbChain limb, Vector3 axis)
    {
        double area = 0;
        for (int t = 0; t < mesh.Triangles.Length; t += 3)
        {
            if (Enumerable.Range(t, 3).All(corner => limb.Joints.Contains(mesh.Weights[mesh.Triangles[corner]].Joint0)))
            {
                Vector3 a = mesh.Positions[mesh.Triangles[t]];
                area += Math.Abs(Vector3.Dot(Vector3.Cross(mesh.Positions[mesh.Triangles[t + 1]] - a, mesh.Positions[mesh.Triangles[t + 2]] - a), axis));
            }
        }

        return area;
    }
}
