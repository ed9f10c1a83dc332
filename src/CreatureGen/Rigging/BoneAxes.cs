using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// The axes in which the limits of a joint are given: Y along its bone, X and Z as near to the joint's own as they can be. Joints of grown creatures have their bones along +Y,
/// so that these axes are their own; skeletons from elsewhere have them along any axis.
/// </summary>
public static class BoneAxes
{
    /// <summary>From the axes of the bone to those of the joint: the shortest turn from +Y to <see cref="Joint.Along"/>; exactly the identity for bones along +Y.</summary>
    public static Quaternion Of(Joint joint) => AreOwn(joint) ? Quaternion.Identity : Rotation.FromTo(Vector3.UnitY, joint.Along);

    /// <summary>Whether the axes of the bone are the joint's own.</summary>
    internal static bool AreOwn(Joint joint) => joint.Along == Vector3.UnitY;
}
