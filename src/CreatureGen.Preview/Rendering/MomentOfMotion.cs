using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Scenes;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Rendering;

/// <summary>The moment of its motion in which a creature has its portrait taken.</summary>
internal static class MomentOfMotion
{
    // Parts of a cycle: a foot is in the air while another stands ahead; a tail is bent to the side, or on its way down with the fins up; the wings are at their highest.
    private const float OfStep = 0.3f;
    private const float OfStrokeAside = 0f;
    private const float OfStroke = 0.15f;
    private const float OfBeat = 0f;

    /// <summary>The surface in mid-step, in mid-stroke, at the top of its wings' beat, in the bends of its crawl; as it was built where it does not go.</summary>
    public static RenderMesh Of(Creature creature)
    {
        var profile = new MotionProfile(creature);
        (string Name, float Part)? moment = Choose(profile, creature.Blueprint.Plan);
        if (moment is not { } chosen)
        {
            return RenderMesh.From(creature);
        }

        Clip clip = ClipBaker.RecipesOf(profile).First(recipe => recipe.Name == chosen.Name).Bake();
        var local = new Pose(new Quaternion[creature.Skeleton.Count], new Vector3[creature.Skeleton.Count]);
        clip.Sample(chosen.Part * clip.Duration, local);
        (Vector3[] positions, Vector3[] normals) = MovedSkin.Of(creature, RootPlace.Identity, local, RootPlace.Identity);
        return RenderMesh.From(creature, positions, normals);
    }

    private static (string Name, float Part)? Choose(MotionProfile profile, BodyPlan plan) => profile switch
    {
        { Flight: not null } => ("Fly", OfBeat),
        { Swim: not null } => ("Swim", plan is BodyPlan.Fish or BodyPlan.Eel ? OfStrokeAside : OfStroke),
        { Slither: not null } => ("Slither", OfStep),
        { Gaits: not null } => (Movement.OfGoing(profile).First(movement => movement.Gait != null).Name, OfStep),
        _ => null,
    };
}
