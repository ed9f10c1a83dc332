using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Rigging;

namespace CreatureGen.Creatures;

/// <summary>Mass and its distribution, from the closed surface at uniform density.</summary>
/// <param name="Mass">Kilograms.</param>
/// <param name="Volume">Cubic metres.</param>
/// <param name="Centre">Centre of mass, model space, metres.</param>
/// <param name="InertiaDiagonal">Moments of inertia about the centre: xx, yy, zz, kg·m².</param>
/// <param name="InertiaProducts">Entries xy, yz, zx of the inertia tensor about the centre (already with their minus sign), kg·m².</param>
public sealed record MassProperties(float Mass, float Volume, Vector3 Centre, Vector3 InertiaDiagonal, Vector3 InertiaProducts);

/// <summary>A finished creature: immutable, and safe to share between threads.</summary>
/// <param name="Blueprint">What it was built from.</param>
/// <param name="Mesh">Its surface.</param>
/// <param name="Skeleton">Its joints.</param>
/// <param name="Limbs">Its limbs as chains of joints.</param>
/// <param name="AttachmentPoints">Top, left and right of every spine bone.</param>
/// <param name="Sockets">Frames in which things are worn, held or ridden: saddle, head, mouth, tip of the tail and hands among them.</param>
/// <param name="Body">The capsule that stands for the whole creature, in the space of the root joint.</param>
/// <param name="Bones">A capsule for each bone that moves skin.</param>
/// <param name="Mass">Mass and inertia.</param>
/// <param name="StandingHeight">Height of the body's centre above the ground, metres.</param>
/// <param name="DefaultSpeed">Metres per second.</param>
public sealed record Creature(
    CreatureBlueprint Blueprint,
    CreatureMesh Mesh,
    Skeleton Skeleton,
    IReadOnlyList<LimbChain> Limbs,
    IReadOnlyList<AttachmentPoint> AttachmentPoints,
    IReadOnlyList<CreatureSocket> Sockets,
    CapsuleCollider Body,
    IReadOnlyList<CapsuleCollider> Bones,
    MassProperties Mass,
    float StandingHeight,
    float DefaultSpeed);
