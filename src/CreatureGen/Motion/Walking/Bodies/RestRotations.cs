using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>Writes turns given in the model's axes at rest as local rotations: a joint turned by R about the model's axes, relative to its parent's turn.</summary>
internal sealed class RestRotations
{
    private readonly Quaternion[] before;
    private readonly Quaternion[] after;
    private readonly Vector3[] positions;

    public RestRotations(Skeleton skeleton)
    {
        int count = skeleton.Count;
        before = new Quaternion[count];
        after = new Quaternion[count];
        positions = skeleton.LocalPositions.ToArray();
        for (int i = 0; i < count; i++)
        {
            int parent = skeleton.Parents[i];
            before[i] = parent < 0 ? Quaternion.Identity : Rotation.Inverse(skeleton.ModelRotations[parent]);
            after[i] = skeleton.ModelRotations[i];
        }
    }

    /// <summary>Turns a joint away from rest. What two products lose of the length of a unit turn is not made up for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(in Pose local, int joint, Quaternion turn) => local.Rotations[joint] = Local(joint, turn);

    /// <summary>The local rotation of a joint that is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Local(int joint, Quaternion turn) => Rotation.Multiply(before[joint], Rotation.Multiply(turn, after[joint]));

    /// <summary>How far a joint is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Of(in Pose local, int joint) => Of(joint, local.Rotations[joint]);

    /// <summary>How far a joint with a local rotation is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Of(int joint, Quaternion local) =>
        UnitRotation.Renormalize(Rotation.Multiply(Rotation.Multiply(Rotation.Inverse(before[joint]), local), Rotation.Inverse(after[joint])));

    /// <summary>Slides a joint away from rest.</summary>
    public void Slide(in Pose local, int joint, Vector3 slide) =>
        local.Positions[joint] = positions[joint] + Rotation.Rotate(before[joint], slide);
}
