using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// Orientations of joints in rest pose, by one convention: local +Y points along the bone, and the roll about it is fixed so that hinges bend about local X.
/// </summary>
/// <remarks>
/// <para>Along the spine, in legs under the body and in feet, local +X is the model's left axis as far as the bone allows: the bone swings fore and aft about X.
/// Bones that lie out to the side (wings, fins, girdles, thighs of sprawlers, legs of insects) have local +X ahead and local +Z up: the bone is raised by a positive turn about X.</para>
/// <para>The frame of a joint on the right is the mirror image of its left counterpart's (<see cref="Rotation.Mirror"/>): equal turns about X, opposite turns about Y and Z, are mirror images.</para>
/// </remarks>
internal static class JointFrame
{
    /// <summary>Below this share of its length, an axis left over across the bone gives no stable roll.</summary>
    private const float MinAcross = 0.2f;

    /// <summary>A bone in the sagittal plane: local +X is exactly the model's +X.</summary>
    /// <param name="direction">Of the bone, any length; its x is ignored.</param>
    public static Quaternion Median(Vector3 direction)
    {
        Vector3 along = Vec.Normalize(new Vector3(0f, direction.Y, direction.Z), Vector3.UnitY);
        return Rotation.FromBasis(Vector3.UnitX, along, Vec.Cross(Vector3.UnitX, along));
    }

    /// <summary>A bone whose local +X is <paramref name="hinge"/> as far as possible.</summary>
    /// <param name="direction">Of the bone, any length.</param>
    /// <param name="hinge">Unit.</param>
    public static Quaternion Hinged(Vector3 direction, Vector3 hinge)
    {
        Vector3 along = Vec.Normalize(direction, -Vector3.UnitY);
        Vector3 across = Vec.Reject(hinge, along);
        if (Vec.Length(across) < MinAcross)
        {
            across = Vec.Reject(along.X * along.X > 0.5f ? Vector3.UnitZ : Vector3.UnitX, along);
        }

        across = Vec.Normalize(across);
        return Rotation.FromBasis(across, along, Vec.Cross(across, along));
    }

    /// <summary>A bone whose local +Z is <paramref name="up"/> as far as possible.</summary>
    /// <param name="direction">Of the bone, any length.</param>
    /// <param name="up">Unit.</param>
    public static Quaternion Raised(Vector3 direction, Vector3 up)
    {
        Vector3 along = Vec.Normalize(direction, Vector3.UnitX);
        Vector3 over = Vec.Reject(up, along);
        if (Vec.Length(over) < MinAcross)
        {
            over = Vec.Reject(-Vector3.UnitZ, along);
        }

        over = Vec.Normalize(over, Vec.Perpendicular(along));
        return Rotation.FromBasis(Vec.Cross(along, over), along, over);
    }
}
