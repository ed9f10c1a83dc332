using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Sampling;

/// <summary>What consecutive seeds give, with the shapes of the bodies: for claims about outlines.</summary>
internal static class DrawnShapes
{
    /// <summary>The creatures of some seeds, one after another.</summary>
    public static IEnumerable<(CreatureBlueprint Creature, BodyShape Shape)> Of(RequestedKind kind, double strangeness, ulong first, int count)
    {
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, Strangeness = strangeness });
            yield return (creature, BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail));
        }
    }
}
