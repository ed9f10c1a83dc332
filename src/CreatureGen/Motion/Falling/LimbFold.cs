using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Takes legs, arms and wings over the ground to where they belong: turned straight there they would go through it and lift the body. The joints of each turn by as much as each of them raises its lowest point (damped least squares), so that nothing turns over where that point is right below a joint; it goes on from how it was folded before, so that it does not go to and fro between two ways around.</summary>
internal static class LimbFold
{
    /// <summary>Radians by which a joint turns in a round at most.</summary>
    private const float MaxTurn = 0.25f;

    /// <summary>Lever below which a limb is folded less, part of its length.</summary>
    private const float Damped = 0.3f;

    /// <summary>How much faster a joint turns out of the ground than towards where it belongs, at most.</summary>
    private const float Haste = 2f;

    /// <summary>Folds all of them.</summary>
    /// <param name="profile">Whose.</param>
    /// <param name="limbs">Which.</param>
    /// <param name="pose">Its local pose, in which limbs are where they belong, is changed, that in model space brought up to date.</param>
    /// <param name="folded">How they were folded before, in the parents' space; receives how they are now.</param>
    /// <param name="step">How far a joint turns from there towards where it belongs at most, radians.</param>
    /// <param name="home">How far they are where they belong in any case, 0..1.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="depth">How far below the ground a limb may be, metres of the model, not positive.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it lies on.</param>
    public static void Up(FallProfile profile, LyingLimb[] limbs, PoseBuffer pose, in Pose folded, float step, float home, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        Span<Quaternion> belongs = stackalloc Quaternion[LyingLimb.MaxJoints];
        foreach (LyingLimb limb in limbs)
        {
            int[] joints = limb.Joints;
            Keep(limb, pose, belongs);

            Follow(profile, limb, pose, folded, step);
            Yield(profile, limb, pose, place, depth, up, ground);
            Follow(profile, limb, pose, folded, Haste * step);
            for (int i = 0; i < joints.Length; i++)
            {
                int joint = joints[i];
                folded.Rotations[joint] = pose.Local.Rotations[joint];

                // What lies between two turns that a joint allows need not be one.
                pose.Local.Rotations[joint] = SwingTwistLimit.ClampLocal(Rotation.Slerp(folded.Rotations[joint], belongs[i], home), profile.Skeleton.Joints[joint]);
            }

            Subtree.LocalToModel(profile.Skeleton, joints[0], pose.Local, pose.Model);
        }
    }

    /// <summary>Lets the joints of a limb turn so far at most.</summary>
    private static void Follow(FallProfile profile, LyingLimb limb, PoseBuffer pose, in Pose folded, float step)
    {
        foreach (int joint in limb.Joints)
        {
            pose.Local.Rotations[joint] = Towards(folded.Rotations[joint], pose.Local.Rotations[joint], step);
        }

        Subtree.LocalToModel(profile.Skeleton, limb.Joints[0], pose.Local, pose.Model);
    }

    /// <summary>Turns the joints of a limb until it is out of the ground, or as far as that goes.</summary>
    /// <param name="profile">Whose.</param>
    /// <param name="limb">Which.</param>
    /// <param name="pose">Its local pose is changed, that in model space brought up to date.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="depth">How far below the ground the limb may be, metres of the model, not positive.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it lies on.</param>
    public static void Yield(FallProfile profile, LyingLimb limb, PoseBuffer pose, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        int hip = limb.Joints[0];
        float damping = Damped * limb.Length * (Damped * limb.Length);
        Span<Quaternion> best = stackalloc Quaternion[LyingLimb.MaxJoints];
        float least = float.MaxValue;
        for (int round = 0; ; round++)
        {
            float sunk = depth - profile.Support.LowestOfLimb(hip, place, pose.Model, up, ground, out Vector3 point);
            if (!(sunk > 1e-4f * limb.Length))
            {
                return;
            }

            if (sunk < least)
            {
                // Pressed between two points it goes to and fro: what was least deep counts, and not what was last.
                least = sunk;
                Keep(limb, pose, best);
            }

            if (round == limb.Yield.Rounds)
            {
                break;
            }

            float levers = damping;
            for (int i = 0; i < limb.Joints.Length; i++)
            {
                levers += limb.Yield.Of(i) * Vec.LengthSquared(Axis(point, pose.Model.Positions[limb.Joints[i]]));
            }

            for (int i = 0; i < limb.Joints.Length; i++)
            {
                int joint = limb.Joints[i];
                Vector3 turn = Axis(point, pose.Model.Positions[joint]) * (limb.Yield.Of(i) * sunk / levers);
                float angle = Vec.Length(turn);
                GroundClearance.Turn(profile.Skeleton, joint, Rotation.FromAxisAngle(Vec.Normalize(turn, Vector3.UnitX), Math.Min(limb.Yield.Part * angle, MaxTurn)), pose);
            }

            Subtree.LocalToModel(profile.Skeleton, hip, pose.Local, pose.Model);
        }

        for (int i = 0; i < limb.Joints.Length; i++)
        {
            pose.Local.Rotations[limb.Joints[i]] = best[i];
        }

        Subtree.LocalToModel(profile.Skeleton, hip, pose.Local, pose.Model);
    }

    private static void Keep(LyingLimb limb, PoseBuffer pose, Span<Quaternion> kept)
    {
        for (int i = 0; i < limb.Joints.Length; i++)
        {
            kept[i] = pose.Local.Rotations[limb.Joints[i]];
        }
    }

    /// <summary>The axis about which a joint raises a point, as long as what it raises it by.</summary>
    private static Vector3 Axis(Vector3 point, Vector3 joint) => Vec.Cross(point - joint, Vector3.UnitY);

    /// <summary>Goes from one turn to another, so far at most.</summary>
    private static Quaternion Towards(Quaternion from, Quaternion to, float step)
    {
        Quaternion way = Rotation.Multiply(Rotation.Inverse(from), to);
        float sine = Vec.Length(new Vector3(way.X, way.Y, way.Z));
        double angle = 2 * PortableMath.Atan2(sine, Math.Abs(way.W));
        return angle > step ? Rotation.Slerp(from, to, (float)(step / angle)) : to;
    }
}
