using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Blueprints;
using CreatureGen.Creatures.Forks;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>Builds creatures from blueprints: runs the stages in order and nothing else. The same blueprint gives the same creature, bit for bit.</summary>
public static class CreatureAssembler
{
    /// <summary>Kilograms per cubic metre of a creature.</summary>
    public const float Density = 1000f;

    /// <summary>Builds a creature.</summary>
    /// <exception cref="ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Assemble(CreatureBlueprint blueprint) => Assemble(blueprint, null);

    /// <summary>Builds a creature and tells an observer after each stage.</summary>
    /// <exception cref="ArgumentException">The blueprint has problems; the message lists them all.</exception>
    public static Creature Assemble(CreatureBlueprint blueprint, IAssemblyObserver? observer)
    {
        BlueprintValidator.ThrowIfInvalid(blueprint);
        float scale = (float)blueprint.Scale;
        GrownSurface grown = GrownSurface.Grow(blueprint);
        using Surface surface = grown.Surface;
        observer?.StageFinished(AssemblyStage.Surface);

        Vector3[] normals = new Vector3[surface.Positions.Length];
        SurfaceNormals.Smooth(surface.Positions, surface.Triangles, surface.Mirror, normals);
        EyeFrame eye = EyeSetter.EyeOf(blueprint, grown);
        var coat = new CoatPainter(blueprint.Coat, CoatSubjects.Of(blueprint, grown, eye));
        (IReadOnlyList<Piece> pieces, IReadOnlyList<Appendage> appendages) = FeatureSetter.Set(blueprint, grown, coat, normals);
        observer?.StageFinished(AssemblyStage.Features);

        var input = new RigInput(blueprint, grown.Skin, surface, grown.Adjacency, appendages.Concat(DiscEdges.Of(blueprint, grown.Skin)).ToArray(), grown.Mouth, EyeSetter.SocketOf(blueprint, eye));
        Rig rig = CreatureRigger.Build(input);
        observer?.StageFinished(AssemblyStage.Rig);

        SkinWeights[] weights = AnatomicalWeights.Solve(input, rig);
        observer?.StageFinished(AssemblyStage.Skin);

        var colours = new Vector3[surface.Positions.Length];
        coat.Paint(surface.Addresses, surface.Positions, surface.Mirror, normals, colours);
        Body body = HeadFork.Apply(blueprint, grown, new Body(surface, normals, colours, weights, pieces, rig));
        CreatureMesh full = MeshAssembler.Assemble(body, scale);
        observer?.StageFinished(AssemblyStage.Appearance);

        FinishedRig finished = body.Rig.Scaled(scale);
        MassProperties mass = Weigh(body.Surface, scale);
        body.Surface.Dispose();
        IReadOnlyList<CapsuleCollider> bones = BoneCapsules.Fit(finished.Skeleton, full.Weights, full.Positions);
        CreatureMesh mesh = CreatureLods.Within(blueprint.TriangleBudget, full);
        var creature = new Creature(blueprint, mesh, finished.Skeleton, finished.Limbs, finished.AttachmentPoints, finished.Sockets, finished.Body, bones, mass, finished.StandingHeight, LocomotionSpeed.Of(blueprint, finished));
        observer?.StageFinished(AssemblyStage.Finish);
        return creature;
    }

    private static MassProperties Weigh(Surface surface, float scale)
    {
        SolidProperties solid = SolidProperties.Of(surface.Positions, surface.Triangles);
        double volume = solid.Volume * scale * scale * scale;
        double moment = Density * scale * scale * scale * scale * scale;
        return new MassProperties(
            (float)(volume * Density),
            (float)volume,
            solid.Centroid * scale,
            new Vector3((float)(solid.InertiaXX * moment), (float)(solid.InertiaYY * moment), (float)(solid.InertiaZZ * moment)),
            new Vector3((float)(solid.InertiaXY * moment), (float)(solid.InertiaYZ * moment), (float)(solid.InertiaZX * moment)));
    }
}
