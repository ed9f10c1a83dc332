using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Brings the end of a chain of any number of joints to a target by turning them one after another, nearest to the end first. Every joint stays within its limits as a whole, not step by step.
/// Nothing is allocated.
/// </summary>
/// <remarks>
/// <para>Cyclic coordinate descent: each joint turns the direction to the end onto the direction to the target. The turn is (v × m, v · m) with m the unit middle of both directions, so no angle
/// is taken and none is doubled; a turn beyond the most allowed is scaled as xyz · sin(most/2)/sin(half), w = cos(most/2). A joint that its limits leave a single axis is a hinge: both directions are laid into the
/// plane across the axis and brought back to unit length; a direction along the axis turns nothing. After each turn the joint's whole turn from rest is brought within its limit
/// (<see cref="SwingTwistLimit"/>), so steps cannot creep beyond it.</para>
/// <para>Starts from the pose as it is: from frame to frame that is a good start, and keeps the motion even. For legs use <see cref="TwoBoneIk"/> or <see cref="PantographIk"/>, which are exact and do not curl.</para>
/// <para>Based on: L.-C. Wang and C. Chen, "A combined optimization method for solving the inverse kinematics problem of mechanical manipulators" (1991); J. Lander, "Making kine more flexible" (1998).</para>
/// </remarks>
public static class CcdIk
{
    private const float Hinged = 1e-4f;
    private const float Standstill = 1e-4f;

    /// <summary>Poses a chain of a skeleton.</summary>
    /// <param name="skeleton">Gives parents, rest pose and limits.</param>
    /// <param name="chain">Joints from the first that turns to the end, which does not turn; each the parent of the next.</param>
    /// <param name="target">Where the end has to be, model space, metres.</param>
    /// <param name="settings">How hard to try.</param>
    /// <param name="local">Pose in the parents' space; the chain's joints but the last are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the first joint outwards.</param>
    /// <exception cref="ArgumentException">The joints are not a chain, a pose is not as long as the skeleton, or a number is not finite.</exception>
    public static IkResult Apply(Skeleton skeleton, ReadOnlySpan<int> chain, Vector3 target, in CcdSettings settings, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        Finite.Require(target, nameof(target));
        float length = Prove(skeleton, chain, local);
        if (settings.Rounds < 1)
        {
            throw new ArgumentException("settings without rounds; expected CcdSettings.Default or settings made by its constructor", nameof(settings));
        }

        int end = chain[chain.Length - 1];
        float near = settings.Tolerance * length;
        float distance = Vec.Distance(model.Positions[end], target);
        float start = Vec.Distance(model.Positions[chain[0]], target);
        for (int round = 0; round < settings.Rounds && distance > near; round++)
        {
            for (int k = chain.Length - 2; k >= 0; k--)
            {
                Turn(skeleton, chain, k, target, settings.MaxTurn, local, model);
            }

            float now = Vec.Distance(model.Positions[end], target);
            bool stuck = Math.Abs(distance - now) < Standstill * distance && round > 2;
            distance = now;
            if (stuck)
            {
                break;
            }
        }

        Subtree.LocalToModel(skeleton, chain[0], local, model);
        return new IkResult(distance <= near ? IkStatus.Reached : start > length ? IkStatus.TooFar : IkStatus.Limited, distance);
    }

    private static float Prove(Skeleton skeleton, ReadOnlySpan<int> chain, in Pose local)
    {
        if (chain.Length < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"a chain of {chain.Length} joints; expected a joint that turns and an end at least"), nameof(chain));
        }

        float length = 0f;
        for (int k = 1; k < chain.Length; k++)
        {
            if ((uint)chain[k] >= (uint)skeleton.Count || skeleton.Parents[chain[k]] != chain[k - 1])
            {
                throw new ArgumentException(FormattableString.Invariant($"chain[{k - 1}] = {chain[k - 1]} is not the parent of chain[{k}] = {chain[k]}; expected a chain without gaps"), nameof(chain));
            }

            length += Vec.Length(local.Positions[chain[k]]);
        }

        return length;
    }

    /// <summary>Turns one joint of the chain and carries along what follows it.</summary>
    private static void Turn(Skeleton skeleton, ReadOnlySpan<int> chain, int k, Vector3 target, float maxTurn, in Pose local, in Pose model)
    {
        int joint = chain[k];
        Joint about = skeleton.Joints[joint];
        JointLimit limit = about.Limit;
        Vector3 place = model.Positions[joint];
        Quaternion toJoint = Rotation.Inverse(model.Rotations[joint]);
        Vector3 from = Rotation.Rotate(toJoint, model.Positions[chain[chain.Length - 1]] - place);
        Vector3 to = Rotation.Rotate(toJoint, target - place);
        if (Width(limit.SwingZ) <= Hinged && Width(limit.Twist) <= Hinged)
        {
            from.X = 0f;
            to.X = 0f;
        }

        if (Vec.LengthSquared(from) < 1e-16f || Vec.LengthSquared(to) < 1e-16f)
        {
            return;
        }

        Quaternion turn = Bounded(Rotation.FromTo(from, to), maxTurn);
        Quaternion turned = Rotation.Normalize(Rotation.Multiply(local.Rotations[joint], turn));
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(turned, about);
        for (int i = k; i < chain.Length; i++)
        {
            Subtree.Place(skeleton.Parents[chain[i]], chain[i], local, model);
        }
    }

    private static float Width(AngleRange range) => range.Max - range.Min;

    private static Quaternion Bounded(Quaternion turn, float max)
    {
        float sine = Vec.Length(new Vector3(turn.X, turn.Y, turn.Z));
        PortableMath.SinCos(0.5 * max, out double maxSine, out double maxCosine);
        if (turn.W >= maxCosine || sine <= 0f)
        {
            return turn;
        }

        float scale = (float)(maxSine / sine);
        return new Quaternion(turn.X * scale, turn.Y * scale, turn.Z * scale, (float)maxCosine);
    }
}
