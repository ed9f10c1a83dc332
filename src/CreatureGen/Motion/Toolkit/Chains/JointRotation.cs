using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>
/// Turns one joint by angles about the axes of the model instead of its own: a turn D leaves the rest pose at the identity, and bones that point anywhere at rest take the same turn alike.
/// </summary>
/// <remarks>
/// With P and R the rest rotations of the parent and of the joint in model space, the local rotation is P⁻¹·D·R. Turns chain from parent to child: the joint's turn in model
/// space is its parent's times D. Turns are brought within the joint's limits, see <see cref="SoftLimit"/>.
/// </remarks>
internal readonly struct JointRotation
{
    private readonly Quaternion parentInverse;
    private readonly Quaternion rest;
    private readonly Quaternion restInverse;
    private readonly JointLimit range;
    private readonly SoftLimit limit;

    /// <summary>Takes what it needs of a joint.</summary>
    public JointRotation(Skeleton skeleton, int joint)
    {
        Joint = joint;
        int parent = skeleton.Parents[joint];
        parentInverse = parent < 0 ? Quaternion.Identity : Rotation.Inverse(skeleton.ModelRotations[parent]);
        rest = skeleton.ModelRotations[joint];
        restInverse = Rotation.Inverse(rest);
        range = skeleton.Joints[joint].Limit;
        limit = new SoftLimit(range);
    }

    /// <summary>Index into the skeleton.</summary>
    public int Joint { get; }

    /// <summary>Writes the local rotation and gives the turn that the limits left.</summary>
    public Quaternion Write(in Pose local, Quaternion turn)
    {
        Quaternion turned = Rotation.Multiply(turn, rest);
        Quaternion own = Rotation.Multiply(restInverse, turned);
        if (limit.Leaves(own))
        {
            local.Rotations[Joint] = UnitRotation.Renormalize(Rotation.Multiply(parentInverse, turned));
            return turn;
        }

        turned = Rotation.Multiply(rest, limit.Apply(own));
        local.Rotations[Joint] = UnitRotation.Renormalize(Rotation.Multiply(parentInverse, turned));
        return Rotation.Multiply(turned, restInverse);
    }

    /// <summary>Writes the local rotation as it is, and at its limit where it goes beyond: for what has to reach its place.</summary>
    public void WriteFirm(in Pose local, Quaternion turn)
    {
        Quaternion own = SwingTwistLimit.Clamp(Rotation.Multiply(restInverse, Rotation.Multiply(turn, rest)), range);
        local.Rotations[Joint] = UnitRotation.Renormalize(Rotation.Multiply(parentInverse, Rotation.Multiply(rest, own)));
    }

    /// <summary>The turn that the limits leave of a turn.</summary>
    public Quaternion Limit(Quaternion turn) => Rotation.Multiply(Rotation.Multiply(rest, limit.Apply(Rotation.Multiply(Rotation.Multiply(restInverse, turn), rest))), restInverse);
}
