using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>Writes turns given in the model's axes at rest as local rotations: a joint turned by R about the model's axes, relative to its parent's turn.</summary>
internal sealed class RestRotations
{
    private readonly Skeleton skeleton;
    private readonly RestFrame[] frames;

    public RestRotations(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        frames = new RestFrame[skeleton.Count];
        for (int i = 0; i < frames.Length; i++)
        {
            int parent = skeleton.Parents[i];
            frames[i].Before = parent < 0 ? Quaternion.Identity : Rotation.Inverse(skeleton.ModelRotations[parent]);
            frames[i].After = skeleton.ModelRotations[i];
        }
    }

    /// <summary>Turns a joint away from rest. What two products lose of the length of a unit turn is not made up for.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(in Pose local, int joint, Quaternion turn) => local.Rotations[joint] = Local(joint, turn);

    /// <summary>The local rotation of a joint that is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Local(int joint, Quaternion turn)
    {
        ref readonly RestFrame frame = ref frames[joint];
        return Rotation.Multiply(frame.Before, Rotation.Multiply(turn, frame.After));
    }

    /// <summary>How far a joint is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Of(in Pose local, int joint) => Of(joint, local.Rotations[joint]);

    /// <summary>How far a joint with a local rotation is turned away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion Of(int joint, Quaternion local)
    {
        ref readonly RestFrame frame = ref frames[joint];
        return UnitRotation.Renormalize(Rotation.Multiply(Rotation.Multiply(Rotation.Inverse(frame.Before), local), Rotation.Inverse(frame.After)));
    }

    /// <summary>Slides a joint away from rest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Slide(in Pose local, int joint, Vector3 slide) =>
        local.Positions[joint] = skeleton.LocalPositions[joint] + Rotation.Rotate(frames[joint].Before, slide);

    /// <summary>From the axes of the model to those of a joint's parent, and from those of the joint to the model's, at rest: side by side, as they are asked for together.</summary>
    private struct RestFrame
    {
        public Quaternion Before;
        public Quaternion After;
    }
}
