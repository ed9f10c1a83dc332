using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>A moment of a clip in model space, with memory of its own.</summary>
internal sealed class ModelPose
{
    private readonly Skeleton skeleton;
    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;

    public ModelPose(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        rotations = new Quaternion[skeleton.Count];
        positions = new Vector3[skeleton.Count];
    }

    /// <summary>The pose.</summary>
    public Pose Pose => new(rotations, positions);

    /// <summary>Takes a moment of a clip.</summary>
    public void Sample(IClip clip, float time)
    {
        clip.Sample(time, Pose);
        ForwardKinematics.LocalToModel(skeleton, Pose, Pose);
    }
}
