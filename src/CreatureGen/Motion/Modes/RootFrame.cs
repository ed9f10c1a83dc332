using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Modes;

/// <summary>The root from which a pose is seen.</summary>
internal static class RootFrame
{
    /// <summary>Writes a pose as seen from another root: the body stays where it is in the world.</summary>
    /// <param name="skeleton">Of the pose.</param>
    /// <param name="body">The joint that carries the body; what carries that is at rest.</param>
    /// <param name="before">From where the pose is seen.</param>
    /// <param name="after">From where it is to be seen.</param>
    /// <param name="local">The pose, in the parents' space.</param>
    public static void Change(Skeleton skeleton, int body, in RootPlace before, in RootPlace after, in Pose local)
    {
        int parent = skeleton.Parents[body];
        Quaternion frame = parent < 0 ? Quaternion.Identity : skeleton.ModelRotations[parent];
        Vector3 origin = parent < 0 ? Vector3.Zero : skeleton.ModelPositions[parent];
        Quaternion back = Rotation.Inverse(frame);
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(after.Rotation), before.Rotation);
        Vector3 place = after.ToModel(before.ToWorld(origin + Rotation.Rotate(frame, local.Positions[body])));
        local.Positions[body] = Rotation.Rotate(back, place - origin);
        local.Rotations[body] = UnitRotation.Renormalize(Rotation.Multiply(back, Rotation.Multiply(turn, Rotation.Multiply(frame, local.Rotations[body]))));
    }
}
