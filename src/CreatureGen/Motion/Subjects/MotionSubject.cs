using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Motion.Subjects;
using CreatureGen.Rigging;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Motion;

/// <summary>A body as motion knows it: bones, limbs, skin, mass and manner, of a creature that was grown or of a skeleton from elsewhere. Immutable, and safe to share between threads.</summary>
public sealed class MotionSubject
{
    /// <summary>A grown creature as a subject of motion.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public MotionSubject(Creature creature)
    {
        Creature = creature ?? throw new ArgumentNullException(nameof(creature));
        CreatureBlueprint blueprint = creature.Blueprint;
        Skeleton = creature.Skeleton;
        Limbs = creature.Limbs;
        Bones = creature.Bones;
        Sockets = creature.Sockets;
        Mesh = creature.Mesh;
        Mass = creature.Mass;
        StandingHeight = creature.StandingHeight;
        DefaultSpeed = creature.DefaultSpeed;
        Kind = blueprint.Kind;
        Plan = blueprint.Plan;
        Seed = blueprint.Seed;
        Manner = SpeciesCatalogue.Find(blueprint.Body.Blend.Manner).Motion;
        HasHorns = blueprint.Features.Any(feature => (feature.Kind is FeatureKind.Horn or FeatureKind.Antler or FeatureKind.Tusk) && feature.Ring <= StationRing.Nape);
        HasSting = blueprint.Tail.Style == TailStyle.Stinger;
        HasMembranes = blueprint.Wings.Any(wing => WingFingers.Of(wing.Style) != null);
        Seed species = new Seed(blueprint.Seed).Child("glances");
        Habits = blueprint.Coat.Marks == 0 ? species : species.Child(blueprint.Coat.Marks);
    }

    /// <summary>What walks in place of a skeleton from elsewhere.</summary>
    internal MotionSubject(StandIn body, StandInFlesh flesh)
    {
        Skeleton = body.Skeleton;
        Limbs = body.Limbs;
        Bones = flesh.Bones;
        Sockets = Array.Empty<CreatureSocket>();
        Mesh = flesh.Skin;
        Mass = flesh.Mass;
        StandingHeight = Skeleton.ModelPositions[1].Y;
        DefaultSpeed = (float)LocomotionSpeed.OnLegs(Skeleton.ModelPositions[Limbs[0].Joints[1]].Y);
        Kind = LocomotionKind.Walking;
        Plan = body.Plan;
        Manner = new MotionTraits();
        Habits = new Seed(Seed).Child("glances");
    }

    /// <summary>The creature that was grown; null for a skeleton from elsewhere.</summary>
    public Creature? Creature { get; }

    /// <summary>Its joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>Its limbs as chains of joints.</summary>
    public IReadOnlyList<LimbChain> Limbs { get; }

    /// <summary>A capsule for each bone that moves skin.</summary>
    public IReadOnlyList<CapsuleCollider> Bones { get; }

    /// <summary>Frames in which things are worn, held or ridden.</summary>
    public IReadOnlyList<CreatureSocket> Sockets { get; }

    /// <summary>Mass and inertia.</summary>
    public MassProperties Mass { get; }

    /// <summary>Height of the body's centre above the ground, metres.</summary>
    public float StandingHeight { get; }

    /// <summary>Metres per second.</summary>
    public float DefaultSpeed { get; }

    /// <summary>Whether it walks, flies or swims.</summary>
    public LocomotionKind Kind { get; }

    /// <summary>How its body and legs are laid out.</summary>
    public BodyPlan Plan { get; }

    /// <summary>What its scripts and habits are drawn from.</summary>
    public ulong Seed { get; }

    /// <summary>Its skin, which tells soles, belly and what touches the ground.</summary>
    internal CreatureMesh Mesh { get; }

    /// <summary>How it carries itself, beyond what its plan says.</summary>
    internal MotionTraits Manner { get; }

    /// <summary>Whether it can gore: horns, antlers or tusks on its head, not spikes along its back.</summary>
    internal bool HasHorns { get; }

    /// <summary>Whether its tail ends in a sting.</summary>
    internal bool HasSting { get; }

    /// <summary>Whether its wings are skin between fingers, which cannot slide over one another as feathers do.</summary>
    internal bool HasMembranes { get; }

    /// <summary>What its glances, blinks and idle acts are drawn from: individuals of one species differ.</summary>
    internal Seed Habits { get; }
}
