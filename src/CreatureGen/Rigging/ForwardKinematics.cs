using System;
using System.Numerics;
using CreatureGen.Maths;

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
        Chain(skeleton.Outwards, skeleton.Parents, local.Rotations, local.Positions, model.Rotations, model.Positions);
    }

    /// <summary>The same over plain spans of equal length; the first joint is the root.</summary>
    /// <param name="outwards">Every joint once, parents before children. Where joints of different chains take turns, none waits for the one before it.</param>
    /// <param name="parents">The parent of each joint.</param>
    /// <param name="localRotations">In the parents' space.</param>
    /// <param name="localPositions">In the parents' space.</param>
    /// <param name="modelRotations">Receives them in model space.</param>
    /// <param name="modelPositions">Receives them in model space.</param>
    internal static void Chain(
        ReadOnlySpan<int> outwards,
        ReadOnlySpan<int> parents,
        ReadOnlySpan<Quaternion> localRotations,
        ReadOnlySpan<Vector3> localPositions,
        Span<Quaternion> modelRotations,
        Span<Vector3> modelPositions)
    {
        int count = outwards.Length;
        parents = parents.Slice(0, count);
        localRotations = localRotations.Slice(0, count);
        localPositions = localPositions.Slice(0, count);
        modelRotations = modelRotations.Slice(0, count);
        modelPositions = modelPositions.Slice(0, count);
        if (count == 0)
        {
            return;
        }

        modelRotations[0] = localRotations[0];
        modelPositions[0] = localPositions[0];

#if NET
        for (int k = 1; k < count; k++)
        {
            int i = outwards[k];
            int parent = parents[i];
            Quaternion turn = modelRotations[parent];
            modelPositions[i] = modelPositions[parent] + Rotation.Rotate(turn, localPositions[i]);
            modelRotations[i] = Rotation.Multiply(turn, localRotations[i]);
        }
#else
        // Written out and by reference: calls and copies of structures cost several times the arithmetic on interpreters.
        for (int k = 1; k < count; k++)
        {
            int i = outwards[k];
            int parent = parents[i];
            ref readonly Quaternion a = ref modelRotations[parent];
            ref readonly Vector3 o = ref modelPositions[parent];
            ref readonly Quaternion b = ref localRotations[i];
            ref readonly Vector3 v = ref localPositions[i];
            float ax = a.X;
            float ay = a.Y;
            float az = a.Z;
            float aw = a.W;
            float bx = b.X;
            float by = b.Y;
            float bz = b.Z;
            float bw = b.W;
            float vx = v.X;
            float vy = v.Y;
            float vz = v.Z;
            float tx = 2f * ((ay * vz) - (az * vy));
            float ty = 2f * ((az * vx) - (ax * vz));
            float tz = 2f * ((ax * vy) - (ay * vx));
            ref Vector3 p = ref modelPositions[i];
            p.X = o.X + (vx + (aw * tx) + ((ay * tz) - (az * ty)));
            p.Y = o.Y + (vy + (aw * ty) + ((az * tx) - (ax * tz)));
            p.Z = o.Z + (vz + (aw * tz) + ((ax * ty) - (ay * tx)));
            ref Quaternion q = ref modelRotations[i];
            q.X = (aw * bx) + (ax * bw) + (ay * bz) - (az * by);
            q.Y = (aw * by) - (ax * bz) + (ay * bw) + (az * bx);
            q.Z = (aw * bz) + (ax * by) - (ay * bx) + (az * bw);
            q.W = (aw * bw) - (ax * bx) - (ay * by) - (az * bz);
        }
#endif
    }
}
