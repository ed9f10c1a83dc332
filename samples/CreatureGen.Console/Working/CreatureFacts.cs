using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Console.Working;

/// <summary>What there is to tell of a creature, small enough to be kept when the creature is gone.</summary>
/// <param name="Specimen">Its seed, and which individual it is where that is known.</param>
/// <param name="Kind">How it moves.</param>
/// <param name="Plan">How it carries its body.</param>
/// <param name="Scale">Its size as a factor.</param>
/// <param name="Body">The base bodies that it is mixed from and their parts of it, which sum to 1, the greatest first.</param>
/// <param name="Limbs">How many limbs of each kind it has.</param>
/// <param name="Joints">Number of joints.</param>
/// <param name="Vertices">Number of vertices.</param>
/// <param name="Triangles">Number of triangles.</param>
/// <param name="Materials">Triangles of each material.</param>
/// <param name="Min">Lower corner of its bounding box, metres.</param>
/// <param name="Max">Upper corner of its bounding box, metres.</param>
/// <param name="Mass">Kilograms.</param>
/// <param name="Speed">Metres per second.</param>
internal sealed record CreatureFacts(
    Specimen Specimen,
    LocomotionKind Kind,
    BodyPlan Plan,
    double Scale,
    IReadOnlyList<(string Name, double Part)> Body,
    IReadOnlyList<(LimbKind Kind, int Count)> Limbs,
    int Joints,
    int Vertices,
    int Triangles,
    IReadOnlyList<(MaterialKind Material, int Triangles)> Materials,
    Vector3 Min,
    Vector3 Max,
    float Mass,
    float Speed)
{
    /// <summary>Width (x), height (y) and length (z) of its bounding box, metres.</summary>
    public Vector3 Size => Max - Min;

    /// <summary>The facts of a creature of which only its blueprint tells.</summary>
    public static CreatureFacts Of(Creature creature) => Of(creature, new Specimen(creature.Blueprint.Seed, null));

    /// <summary>The facts of a creature that was asked for.</summary>
    public static CreatureFacts Of(Creature creature, Specimen specimen)
    {
        CreatureMesh mesh = creature.Mesh;
        Vector3 least = mesh.Positions[0];
        Vector3 greatest = least;
        foreach (Vector3 position in mesh.Positions)
        {
            least = Vector3.Min(least, position);
            greatest = Vector3.Max(greatest, position);
        }

        CreatureBlueprint blueprint = creature.Blueprint;
        return new CreatureFacts(
            specimen,
            blueprint.Kind,
            blueprint.Plan,
            blueprint.Scale,
            PartsOf(blueprint.Body.Blend),
            creature.Limbs.GroupBy(limb => limb.Kind).OrderBy(group => group.Key).Select(group => (group.Key, group.Count())).ToArray(),
            creature.Skeleton.Count,
            mesh.Positions.Length,
            mesh.Triangles.Length / 3,
            mesh.Parts.Select(part => (part.Material, part.IndexCount / 3)).ToArray(),
            least,
            greatest,
            creature.Mass.Mass,
            creature.DefaultSpeed);
    }

    private static (string Name, double Part)[] PartsOf(BodyBlend blend)
    {
        IEnumerable<(string Name, double Part)> parts = blend.Bodies.Select((body, i) => (body.Name, blend.TorsoFractions[i]));
        return parts.GroupBy(part => part.Name).Select(group => (group.Key, group.Sum(part => part.Part))).Where(part => part.Item2 > 0).OrderByDescending(part => part.Item2).ToArray();
    }
}
