using System.Numerics;

namespace CreatureGen.Rigging;

/// <summary>A pose in the parents' space with memory of its own; at rest to begin with.</summary>
internal sealed class LocalPose
{
    private readonly Skeleton skeleton;
    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;

    public LocalPose(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        rotations = skeleton.LocalRotations.ToArray();
        positions = skeleton.LocalPositions.ToArray();
    }

    /// <summary>The pose, to read and to write.</summary>
    public Pose Pose => new(rotations, positions);

    /// <summary>Sets all joints to rest.</summary>
    public void SetToRest() => Pose.SetToRest(skeleton);

    /// <summary>Takes over another pose of the skeleton.</summary>
    public void Take(in Pose pose)
    {
        pose.Rotations.CopyTo(rotations);
        pose.Positions.CopyTo(positions);
    }
}
