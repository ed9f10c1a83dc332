using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class MomentOfStrokeTests
{
    /// <summary>It was two fifths as broad as high, a board.</summary>
    [Fact]
    public void In_a_portrait_the_fin_of_a_sharks_tail_turns_its_edge_to_who_stands_behind()
    {
        Creature creature = SpeciesSubject.Of("shark", RequestedKind.Swimming);
        Vector3[] fin = EndOfTail(creature, MomentOfMotion.Of(creature));
        float breadth = fin.Max(p => p.X) - fin.Min(p => p.X);
        float height = fin.Max(p => p.Y) - fin.Min(p => p.Y);
        Assert.True(breadth < 0.3f * height, FormattableString.Invariant($"{breadth / height} of its height across"));
    }

    /// <summary>They hung by .10 and .16 m.</summary>
    [Theory]
    [InlineData(0UL)]
    [InlineData(1UL)]
    public void In_a_portrait_the_flukes_of_a_dolphin_do_not_hang(ulong seed)
    {
        Creature creature = SpeciesSubject.Of("dolphin", RequestedKind.Swimming, seed);
        float raised = EndOfTail(creature, MomentOfMotion.Of(creature)).Average(p => p.Y) - EndOfTail(creature, RenderMesh.From(creature)).Average(p => p.Y);
        Assert.True(raised > 0f, FormattableString.Invariant($"raised by {raised} m"));
    }

    /// <summary>The skin that the last bone of a body's axis moves.</summary>
    private static Vector3[] EndOfTail(Creature creature, RenderMesh mesh)
    {
        AxialChain chain = new MotionProfile(creature).Swim!.Chain;
        int last = chain.Bones[chain.Count - 1].Turn.Joint;
        Vector3[] positions = mesh.Positions.ToArray();
        return [.. Enumerable.Range(0, creature.Mesh.Positions.Length).Where(v => creature.Mesh.Weights[v].Joint0 == last).Select(v => positions[v])];
    }
}
