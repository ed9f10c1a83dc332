using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;

namespace CreatureGen.Rigging;

/// <summary>The left eye; the right one is its mirror image. Model space, metres at scale 1.</summary>
internal readonly struct EyeSocket
{
    public EyeSocket(Vector3 centre, Vector3 gaze, float radius)
    {
        Centre = centre;
        Gaze = gaze;
        Radius = radius;
    }

    public Vector3 Centre { get; }

    /// <summary>Unit direction of the pupil at rest.</summary>
    public Vector3 Gaze { get; }

    public float Radius { get; }
}

/// <summary>What a rig and its weights are made from: the finished surface and what is known of its anatomy. Everything at scale 1.</summary>
/// <param name="Blueprint">Gives kind, plan, scale and mouth.</param>
/// <param name="Skin">The body without its limbs.</param>
/// <param name="Surface">The welded surface.</param>
/// <param name="Adjacency">Its neighbourhoods.</param>
/// <param name="Appendages">Indexed by <see cref="VertexAddress.Appendage"/>; those without vertices of their own (antennae, insect wings) come after all others.</param>
/// <param name="Mouth">Its lips.</param>
/// <param name="Eye">The left eye; null for a head without movable eyes.</param>
internal sealed record RigInput(
    CreatureBlueprint Blueprint,
    BodySkin Skin,
    Surface Surface,
    SurfaceAdjacency Adjacency,
    IReadOnlyList<Appendage> Appendages,
    MouthSeam Mouth,
    EyeSocket? Eye);
