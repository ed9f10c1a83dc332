using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A pose with memory of its own.</summary>
internal sealed class PoseBuffer
{
    private readonly Skeleton skeleton;
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;

    public PoseBuffer(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        localRotations = new Quaternion[skeleton.Count];
        localPositions = new Vector3[skeleton.Count];
        modelRotations = new Quaternion[skeleton.Count];
        modelPositions = new Vector3[skeleton.Count];
    }

    /// <summary>In the parents' space.</summary>
    public Pose Local => new(localRotations, localPositions);

    /// <summary>In model space.</summary>
    public Pose Model => new(modelRotations, modelPositions);

    /// <summary>Sets all joints to rest.</summary>
    public void Clear() => Local.SetToRest(skeleton);

    /// <summary>Brings the pose in model space up to date.</summary>
    public void Finish() => ForwardKinematics.LocalToModel(skeleton, Local, Model);

    /// <summary>Takes over a local pose, and brings its model space up to date.</summary>
    public void Take(in Pose local)
    {
        local.Rotations.CopyTo(localRotations);
        local.Positions.CopyTo(localPositions);
        Finish();
    }
}
