using System;
using System.Numerics;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Engines;

/// <summary>A skeleton as an engine takes it: joints keep their numbers and parents, and each method fills spans that the caller owns.</summary>
public sealed class EngineSkeleton
{
    private readonly Skeleton skeleton;

    /// <summary>The skeleton for an engine.</summary>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    public EngineSkeleton(Skeleton skeleton, EngineAxes axes)
    {
        this.skeleton = skeleton ?? throw new ArgumentNullException(nameof(skeleton));
        Axes = axes ?? throw new ArgumentNullException(nameof(axes));
    }

    /// <summary>How the engine counts.</summary>
    public EngineAxes Axes { get; }

    /// <summary>Number of joints.</summary>
    public int Count => skeleton.Count;

    /// <summary>Fills in the rest pose, each joint in its parent's space. Poses of an animator are converted each frame by <see cref="EngineAxes.Convert(in Pose, in Pose)"/>.</summary>
    /// <exception cref="ArgumentException">The pose does not have one entry per joint.</exception>
    public void FillRestPose(in Pose destination)
    {
        EngineAxes.RequireLength(destination.Rotations.Length, Count, "joints", nameof(destination));
        for (int i = 0; i < Count; i++)
        {
            destination.Rotations[i] = Axes.Rotation(skeleton.LocalRotations[i]);
            destination.Positions[i] = Axes.Point(skeleton.LocalPositions[i]);
        }
    }

    /// <summary>Fills in the inverse bind matrices, from model space at rest to each joint's (Unity: <c>bindposes</c>).</summary>
    /// <exception cref="ArgumentException">The span does not have one entry per joint.</exception>
    public void FillInverseBinds(Span<Matrix4x4> destination)
    {
        SkinMatrices.FillInverseBinds(skeleton, destination);
        for (int i = 0; i < destination.Length; i++)
        {
            destination[i] = Axes.Matrix(destination[i]);
        }
    }
}
