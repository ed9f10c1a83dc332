using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>Turns all joints of a chain at once by the smallest turns that bring its end to the target, as far as turns are small.</summary>
/// <remarks>
/// With r from a joint to the end, a turn w moves the end by w × r; of all w the least that give the step e are w = r × f with (Σ (r²I − r rᵀ) + λ²I) f = e, of hinges about a: w = a((a × r) · f) with (a × r)(a × r)ᵀ in the sum.
/// A joint that its limits have kept from what it was to turn counts for less in the next step. Based on: C. W. Wampler (1986); S. R. Buss, "Introduction to inverse kinematics" (2004).
/// </remarks>
internal static class LeastSquaresStep
{
    /// <summary>λ in lengths of the chain: steps near the end of its reach stay small.</summary>
    private const float Damping = 0.03f;

    /// <summary>Farthest step of the end, in lengths of the chain.</summary>
    private const float MaxStep = 0.35f;

    /// <summary>Least gain of a joint at its limit, which the step may turn back from it.</summary>
    private const float MinGain = 0.1f;

    /// <summary>Takes a step.</summary>
    /// <param name="skeleton">Gives parents and limits.</param>
    /// <param name="chain">Joints, the last of which is the end.</param>
    /// <param name="target">Model space.</param>
    /// <param name="length">Of the chain.</param>
    /// <param name="maxTurn">Radians that a joint turns at most.</param>
    /// <param name="gains">One for each joint, kept from step to step; 1 to begin with.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">The same in model space.</param>
    public static void Turn(Skeleton skeleton, ReadOnlySpan<int> chain, Vector3 target, float length, float maxTurn, Span<float> gains, in Pose local, in Pose model)
    {
        Vector3 end = model.Positions[chain[chain.Length - 1]];
        Vector3 error = target - end;
        float far = Vec.Length(error);
        error = far > MaxStep * length ? error * (MaxStep * length / far) : error;
        Vector3 force = Force(skeleton, chain, end, error, length, gains, model);
        for (int k = 0; k < chain.Length - 1; k++)
        {
            Joint joint = skeleton.Joints[chain[k]];
            Vector3 turn = Vec.Cross(end - model.Positions[chain[k]], force) * (gains[k] * gains[k]);
            Quaternion toJoint = Rotation.Inverse(model.Rotations[chain[k]]);
            Vector3 own = Rotation.Rotate(toJoint, turn);
            if (JointChain.IsHinge(joint.Limit))
            {
                Vector3 axis = Rotation.Rotate(BoneAxes.Of(joint), Vector3.UnitX);
                own = axis * Vec.Dot(axis, own);
            }

            float angle = Vec.Length(own);
            if (angle < 1e-9f)
            {
                continue;
            }

            Quaternion before = local.Rotations[chain[k]];
            Quaternion turned = Rotation.Normalize(Rotation.Multiply(before, Rotation.FromAxisAngle(own / angle, Math.Min(angle, maxTurn))));
            local.Rotations[chain[k]] = SwingTwistLimit.ClampLocal(turned, joint);
            float missed = (float)Rotation.AngleBetween(turned, local.Rotations[chain[k]]);
            gains[k] = Scalar.Clamp(1f - (missed / Math.Min(angle, maxTurn)), MinGain, 1f);
        }

        for (int k = 0; k < chain.Length; k++)
        {
            Subtree.Place(skeleton.Parents[chain[k]], chain[k], local, model);
        }
    }

    private static Vector3 Force(Skeleton skeleton, ReadOnlySpan<int> chain, Vector3 end, Vector3 error, float length, ReadOnlySpan<float> gains, in Pose model)
    {
        float damping = Damping * length;
        float xx = damping * damping;
        float yy = xx;
        float zz = xx;
        float xy = 0f;
        float xz = 0f;
        float yz = 0f;
        for (int k = 0; k < chain.Length - 1; k++)
        {
            Joint joint = skeleton.Joints[chain[k]];
            Vector3 r = end - model.Positions[chain[k]];
            float gain = gains[k] * gains[k];
            if (JointChain.IsHinge(joint.Limit))
            {
                Vector3 axis = Rotation.Rotate(model.Rotations[chain[k]], Rotation.Rotate(BoneAxes.Of(joint), Vector3.UnitX));
                Vector3 c = Vec.Cross(axis, r);
                (xx, yy, zz) = (xx + (gain * c.X * c.X), yy + (gain * c.Y * c.Y), zz + (gain * c.Z * c.Z));
                (xy, xz, yz) = (xy + (gain * c.X * c.Y), xz + (gain * c.X * c.Z), yz + (gain * c.Y * c.Z));
            }
            else
            {
                (xx, yy, zz) = (xx + (gain * ((r.Y * r.Y) + (r.Z * r.Z))), yy + (gain * ((r.X * r.X) + (r.Z * r.Z))), zz + (gain * ((r.X * r.X) + (r.Y * r.Y))));
                (xy, xz, yz) = (xy - (gain * r.X * r.Y), xz - (gain * r.X * r.Z), yz - (gain * r.Y * r.Z));
            }
        }

        // The inverse of a symmetric matrix times a vector, by the cross products of its columns.
        var a = new Vector3(xx, xy, xz);
        var b = new Vector3(xy, yy, yz);
        var d = new Vector3(xz, yz, zz);
        Vector3 bd = Vec.Cross(b, d);
        float determinant = Vec.Dot(a, bd);
        return new Vector3(Vec.Dot(error, bd), Vec.Dot(error, Vec.Cross(d, a)), Vec.Dot(error, Vec.Cross(a, b))) / determinant;
    }
}
