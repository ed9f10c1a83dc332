using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A pose with memory of its own, in the parents' space and, as often as asked, in model space.</summary>
internal sealed class PoseBuffer
{
    private readonly Skeleton skeleton;
    private readonly LocalPose local;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;

    public PoseBuffer(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        local = new LocalPose(skeleton);
        modelRotations = new Quaternion[skeleton.Count];
        modelPositions = new Vector3[skeleton.Count];
    }

    /// <summary>In the parents' space.</summary>
    public Pose Local => local.Pose;

    /// <summary>In model space.</summary>
    public Pose Model => new(modelRotations, modelPositions);

    /// <summary>Sets all joints to rest.</summary>
    public void Clear() => local.SetToRest();

    /// <summary>Brings the pose in model space up to date.</summary>
    public void Finish() => ForwardKinematics.LocalToModel(skeleton, Local, Model);

    /// <summary>Takes over a local pose.</summary>
    public void Take(in Pose pose) => local.Take(pose);
}
