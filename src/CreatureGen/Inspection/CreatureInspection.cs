using System;
using System.Collections.Generic;
using CreatureGen.Creatures;
using CreatureGen.Geometry;

namespace CreatureGen.Inspection;

/// <summary>Holds a finished creature against what the library promises of every creature. It looks at the buffers that a game would get, and trusts no stage before them.</summary>
public static class CreatureInspection
{
    internal const string Finite = "finite";
    internal const string Closed = "closed";
    internal const string OneSurface = "oneSurface";
    internal const string PositiveVolume = "positiveVolume";
    internal const string Degenerate = "degenerate";
    internal const string Mirrored = "mirrored";
    internal const string Grounded = "grounded";
    internal const string Balanced = "balanced";
    internal const string Weights = "weights";
    internal const string WeightReach = "weightReach";
    internal const string Joints = "joints";
    internal const string Limbs = "limbs";
    internal const string Budget = "budget";

    /// <summary>The names of all invariants, in the order in which they are checked.</summary>
    public static IReadOnlyList<string> Invariants { get; } = new[]
    {
        Finite, Closed, OneSurface, PositiveVolume, Degenerate, Mirrored, Joints, Limbs, Weights, WeightReach, Grounded, Balanced, Budget,
    };

    /// <summary>All invariants that a creature breaks, each with the first place that was found; empty for a sound creature.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static IReadOnlyList<InvariantViolation> Inspect(Creature creature)
    {
        if (creature is null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        var found = new ViolationList();
        SkeletonChecks.Check(creature, found);
        if (MeshChecks.AreFinite(creature.Mesh, found))
        {
            var skin = new WeldedSkin(creature.Mesh);
            MeshChecks.Check(creature, skin, found);
            WeightChecks.Check(creature, found);
            StanceChecks.Check(creature, skin, found);
        }

        return found.All;
    }

    /// <summary>How often the surface at rest cuts through itself: the body, and each piece that is set into it, thin wings and hair too.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static SurfaceCrossings CountCrossings(Creature creature)
    {
        if (creature is null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        return new CrossingCounter(creature.Mesh, creature.Mesh.Triangles).Count();
    }

    /// <summary>
    /// Pairs of triangles of the body and its limbs that cut one another without sharing a vertex. Eyes, teeth, claws and what else is set into the skin are left aside.
    /// </summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static int CountSelfIntersections(Creature creature)
    {
        if (creature is null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        var skin = new WeldedSkin(creature.Mesh);
        return SelfIntersection.Find(skin.Positions, skin.BodyTriangles, new List<(int First, int Second)>());
    }
}
