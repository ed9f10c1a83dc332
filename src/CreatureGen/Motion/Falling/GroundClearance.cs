using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Lays a pose on the ground: the trunk lies on it, head and tail are bent up out of it, and what is in it still lifts the whole body.</summary>
internal static class GroundClearance
{
    private const int Rounds = 4;

    /// <summary>Rounds in which a foot is bent out of the ground, and from which of them on its leg is raised at the hip as well: what points straight down at the end of its ankle cannot bend out of it.</summary>
    private const int FootRounds = 6;
    private const int HipFrom = 2;

    /// <summary>Radians by which a chain is bent in a round at most.</summary>
    private const float MaxBend = 0.4f;

    /// <summary>What damps the turns of a foot, square of a part of its lever.</summary>
    private const float FootDamping = 0.1f;

    /// <summary>Least lever of a chain, part of its length.</summary>
    private const float MinLever = 0.4f;

    /// <summary>Lets the trunk without its wings down onto the ground, or lifts it out of it; the rest goes with it.</summary>
    /// <param name="profile">Whose.</param>
    /// <param name="pose">Its local pose is changed, that in model space brought up to date.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="depth">How far below the ground its lowest point may be, metres of the model, not positive.</param>
    /// <param name="settles">How far it comes down, 0..1; it is lifted out of the ground in any case.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it lies on.</param>
    public static void Settle(FallProfile profile, PoseBuffer pose, in RootPlace place, float depth, float settles, Vector3 up, IGround ground)
    {
        float shift = depth - profile.Support.Lowest(BodyPart.Torso, place, pose.Model, up, ground, out _);
        profile.Raise(pose.Local, shift > 0f ? shift : settles * shift);
        pose.Finish();
    }

    /// <summary>Lifts the whole body out of the ground as far as limbs are in it, bends head and tail up out of it, and lifts it as far as they stay in it.</summary>
    /// <param name="profile">Whose.</param>
    /// <param name="pose">Its local pose is changed, that in model space brought up to date.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="depth">How far below the ground its lowest point may be, metres of the model, not positive.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it lies on.</param>
    /// <returns>How far it was lifted.</returns>
    public static Clearing Clear(FallProfile profile, PoseBuffer pose, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        float lifted = Lift(profile, BodyPart.Trunk | BodyPart.Limb, pose, place, depth, up, ground);
        Bend(profile, profile.Neck, BodyPart.Head, pose, place, depth, up, ground);
        Bend(profile, profile.Tail, BodyPart.Tail, pose, place, depth, up, ground);
        return new Clearing(lifted, Lift(profile, BodyPart.All, pose, place, depth, up, ground));
    }

    /// <summary>Bends head and tail up out of the ground; the body stays.</summary>
    public static void BendUp(FallProfile profile, PoseBuffer pose, in RootPlace place, Vector3 up, IGround ground)
    {
        Bend(profile, profile.Neck, BodyPart.Head, pose, place, 0f, up, ground);
        Bend(profile, profile.Tail, BodyPart.Tail, pose, place, 0f, up, ground);
    }

    /// <summary>Bends a foot up out of the ground at its ankle and its ball, as far as these go, and raises its leg for what is left: no long toes hold a limp body up.</summary>
    public static void BendFoot(FallProfile profile, LyingLeg leg, PoseBuffer pose, in RootPlace place, Vector3 up, IGround ground)
    {
        for (int round = 0; round < FootRounds; round++)
        {
            float sunk = -profile.Support.LowestOfLimb(leg.Rig.Hip, place, pose.Model, up, ground, out Vector3 point);
            if (!(sunk > 1e-4f * leg.Rig.Length))
            {
                return;
            }

            BendUp(profile.Skeleton, leg.Rig.Ankle, point, sunk, pose);
            BendUp(profile.Skeleton, leg.Rig.Ball, point, sunk, pose);
            int raised = leg.Rig.Ankle;
            if (round >= HipFrom)
            {
                raised = leg.Rig.Hip;
                BendUp(profile.Skeleton, raised, point, sunk, pose);
            }

            Subtree.LocalToModel(profile.Skeleton, raised, pose.Local, pose.Model);
        }
    }

    /// <summary>Turns a joint so that a point on it comes up by half as much as it is in the ground (damped least squares: hardly, where the point is right below the joint).</summary>
    private static void BendUp(Skeleton skeleton, int joint, Vector3 point, float sunk, PoseBuffer pose)
    {
        Vector3 lever = point - pose.Model.Positions[joint];
        Vector3 axis = Vec.Cross(lever, Vector3.UnitY);
        float angle = sunk * Vec.Length(axis) / (Vec.LengthSquared(axis) + (FootDamping * Vec.LengthSquared(lever)));
        Turn(skeleton, joint, Rotation.FromAxisAngle(Vec.Normalize(axis, Vector3.UnitX), 0.5f * Math.Min(angle, MaxBend)), pose);
    }

    /// <summary>Turns a joint in model space, within its limits.</summary>
    public static void Turn(Skeleton skeleton, int joint, Quaternion turn, PoseBuffer pose)
    {
        int parent = skeleton.Parents[joint];
        Quaternion carrier = parent < 0 ? Quaternion.Identity : pose.Model.Rotations[parent];
        Quaternion own = Rotation.Multiply(Rotation.Inverse(carrier), Rotation.Multiply(turn, carrier));
        Quaternion bent = Rotation.Normalize(Rotation.Multiply(own, pose.Local.Rotations[joint]));
        pose.Local.Rotations[joint] = SwingTwistLimit.ClampLocal(bent, skeleton.Joints[joint]);
    }

    /// <summary>Bends a chain up out of the ground, as far as its joints go.</summary>
    private static void Bend(FallProfile profile, int[] chain, BodyPart part, PoseBuffer pose, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        if (chain.Length == 0)
        {
            return;
        }

        float length = 0f;
        foreach (int joint in chain)
        {
            length += profile.Skeleton.Joints[joint].Length;
        }

        for (int round = 0; round < Rounds; round++)
        {
            float sunk = depth - profile.Support.Lowest(part, place, pose.Model, up, ground, out Vector3 point);
            if (!(sunk > 1e-4f * length))
            {
                return;
            }

            Vector3 lever = point - pose.Model.Positions[chain[0]];
            lever.Y = 0f;
            float reach = Math.Max(Vec.Length(lever), MinLever * length);
            Vector3 axis = Vec.Normalize(Vec.Cross(lever, Vector3.UnitY), Vector3.UnitX);
            Quaternion turn = Rotation.FromAxisAngle(axis, Math.Min(sunk / reach, MaxBend) / chain.Length);
            foreach (int joint in chain)
            {
                Turn(profile.Skeleton, joint, turn, pose);
            }

            pose.Finish();
        }
    }

    /// <summary>Lifts the whole body as far as some of it is in the ground.</summary>
    private static float Lift(FallProfile profile, BodyPart parts, PoseBuffer pose, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        float left = depth - profile.Support.Lowest(parts, place, pose.Model, up, ground, out _);
        if (!(left > 0f))
        {
            return 0f;
        }

        profile.Raise(pose.Local, left);
        pose.Finish();
        return left;
    }
}
