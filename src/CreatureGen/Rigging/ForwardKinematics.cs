using System;
using System.Numerics;

namespace CreatureGen.Rigging;

/// <summary>From rotations in the parents' space to places in model space. Nothing is allocated.</summary>
public static class ForwardKinematics
{
    /// <summary>Chains a local pose from the root outwards.</summary>
    /// <param name="skeleton">Gives the parents.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">Receives the pose in model space; may lie over the same spans as <paramref name="local"/>.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton.</exception>
    public static void LocalToModel(Skeleton skeleton, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        Chain(skeleton.Parents, local.Rotations, local.Positions, model.Rotations, model.Positions);
    }

    /// <summary>The same over plain spans of equal length; the first joint is the root.</summary>
    internal static void Chain(ReadOnlySpan<int> parents, ReadOnlySpan<Quaternion> localRotations, ReadOnlySpan<Vector3> localPositions, Span<Quaternion> modelRotations, Span<Vector3> modelPositions)
    {
        int count = parents.Length;
        localRotations = localRotations.Slice(0, count);
        localPositions = localPositions.Slice(0, count);
        modelRotations = modelRotations.Slice(0, count);
        modelPositions = modelPositions.Slice(0, count);
        modelRotations[0] = localRotations[0];
        modelPositions[0] = localPositions[0];

        // Written out: calls that pass structures cost several times the arithmetic on interpreters.
        for (int i = 1; i < count; i++)
        {
            int parent = parents[i];
            Quaternion a = modelRotations[parent];
            Quaternion b = localRotations[i];
            Vector3 v = localPositions[i];
            Vector3 o = modelPositions[parent];
            float tx = 2f * ((a.Y * v.Z) - (a.Z * v.Y));
            float ty = 2f * ((a.Z * v.X) - (a.X * v.Z));
            float tz = 2f * ((a.X * v.Y) - (a.Y * v.X));
            modelPositions[i] = new Vector3(
                o.X + (v.X + (a.W * tx) + ((a.Y * tz) - (a.Z * ty))),
                o.Y + (v.Y + (a.W * ty) + ((a.Z * tx) - (a.X * tz))),
                o.Z + (v.Z + (a.W * tz) + ((a.X * ty) - (a.Y * tx))));
            modelRotations[i] = new Quaternion(
                (a.W * b.X) + (a.X * b.W) + (a.Y * b.Z) - (a.Z * b.Y),
                (a.W * b.Y) - (a.X * b.Z) + (a.Y * b.W) + (a.Z * b.X),
                (a.W * b.Z) + (a.X * b.Y) - (a.Y * b.X) + (a.Z * b.W),
                (a.W * b.W) - (a.X * b.X) - (a.Y * b.Y) - (a.Z * b.Z));
        }
    }
}
