using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Limbs;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures.Forks;

/// <summary>Gives a finished body two necks with a head each: what was grown, rigged, skinned and coloured once is there twice in front of the fork, and nothing before this stage knows of it.</summary>
internal static class HeadFork
{
    /// <summary>The body as its blueprint forks it; the same where it does not.</summary>
    public static Body Apply(CreatureBlueprint blueprint, GrownSurface grown, Body body)
    {
        if (blueprint.Fork is not ForkBlueprint fork)
        {
            return body;
        }

        BodyShape shape = grown.Skin.Shape;
        var course = new ForkCourse(shape, fork);
        bool[] doubled = new bool[grown.Appendages.Count];
        for (int a = 0; a < doubled.Length; a++)
        {
            doubled[a] = grown.Appendages[a].Kind == LimbKind.Ear;
        }

        ForkedSurface surface = ForkedSurface.Fork(body.Surface, shape, course, doubled);
        ForkedRig rig = ForkedRig.Fork(body.Rig, course);
        SkinWeights[] weights = ForkedWeights.Solve(body.Weights, surface, rig, body.Rig.Skeleton.Mirrors, (float)shape.Width[fork.Ring]);
        IReadOnlyList<Piece> pieces = ForkedPieces.Of(body.Pieces, body.Surface, surface, rig, course, body.Rig.Skeleton);
        var normals = new Vector3[surface.Source.Length];
        var colours = new Vector3[surface.Source.Length];
        SurfaceNormals.Smooth(surface.Surface.Positions, surface.Surface.Triangles, surface.Surface.Mirror, normals);
        for (int v = 0; v < colours.Length; v++)
        {
            colours[v] = body.Colours[surface.Source[v]];
        }

        return new Body(surface.Surface, normals, colours, weights, pieces, rig.Rig);
    }
}
