using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Rigging;

/// <summary>
/// Rotations and positions of all joints of a skeleton, in spans that the caller owns: one entry per joint, in the skeleton's order.
/// In the parents' space (a local pose) or in model space, as the user of the pose says. Rotations are unit quaternions, positions metres.
/// </summary>
public readonly ref struct Pose
{
    /// <summary>Lays a pose over two spans.</summary>
    /// <exception cref="ArgumentException">The spans differ in length.</exception>
    /// <remarks>The error is made elsewhere, so that this is inlined: poses are laid over arrays several times in a frame.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Pose(Span<Quaternion> rotations, Span<Vector3> positions)
    {
        if (rotations.Length != positions.Length)
        {
            ThrowUnequal(rotations.Length, positions.Length);
        }

        Rotations = rotations;
        Positions = positions;
    }

    /// <summary>One rotation per joint.</summary>
    public Span<Quaternion> Rotations { get; }

    /// <summary>One position per joint.</summary>
    public Span<Vector3> Positions { get; }

    /// <summary>Fills a local pose with the rest pose.</summary>
    /// <exception cref="ArgumentException">The pose is not as long as the skeleton.</exception>
    public void SetToRest(Skeleton skeleton)
    {
        Require(skeleton);
        skeleton.LocalRotations.CopyTo(Rotations);
        skeleton.LocalPositions.CopyTo(Positions);
    }

    /// <summary>Throws unless the pose has one entry per joint of the skeleton.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Require(Skeleton skeleton)
    {
        if (Rotations.Length != skeleton.Count)
        {
            ThrowOtherSkeleton(Rotations.Length, skeleton.Count);
        }
    }

    private static void ThrowUnequal(int rotations, int positions) =>
        throw new ArgumentException(FormattableString.Invariant($"{rotations} rotations and {positions} positions; expected one of each per joint"), nameof(positions));

    private static void ThrowOtherSkeleton(int joints, int expected) => throw new ArgumentException(FormattableString.Invariant($"a pose of {joints} joints; expected the {expected} of the skeleton"));
}
