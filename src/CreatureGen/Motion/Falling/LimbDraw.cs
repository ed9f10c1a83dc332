using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Draws legs in under a body that lies, by the walk's own leg solver: their ankles go along the ground from where they are to where they will be, however the body rolls meanwhile, and the legs fold as their hips come near. Turned straight there they would go through the ground, or lift the body.</summary>
internal static class LimbDraw
{
    /// <summary>Part of its way in which a leg goes over from how it lay to being drawn, and from there to how it will lie.</summary>
    private const float Blending = 0.2f;

    /// <summary>Draws a leg.</summary>
    /// <param name="skeleton">Whose.</param>
    /// <param name="lying">The leg.</param>
    /// <param name="from">Where its ankle was, model space.</param>
    /// <param name="to">Where it will be.</param>
    /// <param name="w">How far on its way it is, 0..1.</param>
    /// <param name="pose">Its local pose is changed, that in model space brought up to date.</param>
    public static void Apply(Skeleton skeleton, LyingLeg lying, Vector3 from, Vector3 to, float w, PoseBuffer pose)
    {
        float weight = Scalar.Smooth(Math.Min(w, 1f - w) / Blending);
        if (weight == 0f)
        {
            return;
        }

        LegRig leg = lying.Rig;
        ReadOnlySpan<Quaternion> rest = skeleton.ModelRotations;
        Quaternion thigh = Rotation.Multiply(pose.Model.Rotations[leg.Hip], Rotation.Inverse(rest[leg.Hip]));
        LegSolver.Solve(leg, lying.Parts, Vec.Lerp(from, to, w) - pose.Model.Positions[leg.Hip], Rotation.Rotate(thigh, leg.Hinge), 0f, 0f, Vector3.Zero, out LegRotations solved);
        Quaternion carrier = pose.Model.Rotations[skeleton.Parents[leg.Hip]];
        Quaternion hip = Rotation.Multiply(Rotation.Inverse(carrier), Rotation.Multiply(solved.Thigh, rest[leg.Hip]));
        Quaternion knee = Rotation.Multiply(leg.KneeRest, new Quaternion(solved.KneeHalfSine, 0f, 0f, solved.Knee.W));
        Go(leg.Hip, hip);
        Go(leg.Knee, knee);
        Subtree.LocalToModel(skeleton, leg.Hip, pose.Local, pose.Model);

        void Go(int joint, Quaternion turn) =>
            pose.Local.Rotations[joint] = Rotation.Slerp(pose.Local.Rotations[joint], SwingTwistLimit.ClampLocal(turn, skeleton.Joints[joint]), weight);
    }
}
