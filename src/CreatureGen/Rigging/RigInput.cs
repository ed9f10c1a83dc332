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

    /// <summary>Its lids; null for an eye without.</summary>
    public LidHinge? Lids { get; init; }
}

/// <summary>The lids of the left eye. Both turn about one axis through its centre.</summary>
internal readonly struct LidHinge
{
    public LidHinge(Vector3 axis, Vector3 upperRim, Vector3 lowerRim, float upperClosing, float lowerClosing)
    {
        Axis = axis;
        UpperRim = upperRim;
        LowerRim = lowerRim;
        UpperClosing = upperClosing;
        LowerClosing = lowerClosing;
    }

    /// <summary>Unit, towards the outer corner of the eye.</summary>
    public Vector3 Axis { get; }

    /// <summary>Unit direction from the eye's centre to the middle of the upper rim at rest; at right angles to the axis.</summary>
    public Vector3 UpperRim { get; }

    /// <summary>The same of the lower rim.</summary>
    public Vector3 LowerRim { get; }

    /// <summary>Radians about the axis that shut the upper lid.</summary>
    public float UpperClosing { get; }

    /// <summary>Radians against the axis that shut the lower lid.</summary>
    public float LowerClosing { get; }
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
