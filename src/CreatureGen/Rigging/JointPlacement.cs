using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>A joint as other programs give it: its rest pose in its parent's space. All else of a <see cref="Joint"/> follows from it, or has a default.</summary>
/// <param name="Name">Unique, of any characters but control characters.</param>
/// <param name="Parent">Index of the parent, smaller than its own; −1 for joint 0.</param>
/// <param name="Rotation">In the parent's space; brought to unit length.</param>
/// <param name="Position">In the parent's space, metres.</param>
public sealed record JointPlacement(string Name, int Parent, Quaternion Rotation, Vector3 Position)
{
    /// <summary>What it is for; if it is not said, <see cref="Skeleton.Build"/> tells it.</summary>
    public JointRole Role { get; init; } = JointRole.Other;

    /// <summary>Left, right, or on the midline; told with the role.</summary>
    public Side Side { get; init; }

    /// <summary>How far it turns, in the axes of its bone (<see cref="BoneAxes"/>); any way to begin with.</summary>
    public JointLimit Limit { get; init; } = JointLimit.Free;
}
