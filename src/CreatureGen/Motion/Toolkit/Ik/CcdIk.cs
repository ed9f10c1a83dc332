using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
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
/// <para>Passes converge slowly where the chain is nearly straight or limits hold it. After a pass that gains little, one damped least-squares step is taken (<see cref="LeastSquaresStep"/>), and another as long as they gain
/// more; a chain that neither moves is bent and tried again. The best pose of all rounds is kept.</para>
/// <para>Starts from the pose as it is: from frame to frame that is a good start, and keeps the motion even. For legs use <see cref="TwoBoneIk"/> or <see cref="PantographIk"/>, which are exact and do not curl.</para>
/// <para>Based on: L.-C. Wang and C. Chen, "A combined optimization method for solving the inverse kinematics problem of mechanical manipulators" (1991); J. Lander, "Making kine more flexible" (1998); C. W. Wampler, "Manipulator inverse kinematic solutions based on vector formulations and damped least-squares methods" (1986).</para>
/// </remarks>
public static class CcdIk
{
    /// <summary>Parts of the distance that a pass leaves: more, and the other kind of step is tried; and of a step that gains nothing.</summary>
    private const float Quick = 0.6f;

    private const float Slow = 0.7f;
    private const float Stall = 0.97f;

    /// <summary>Radians by which a chain is bent that does not move any more.</summary>
    private const float Kick = 0.5f;

    private const int MaxOnStack = 64;

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
        float length = JointChain.Prove(skeleton, chain, local);
        if (settings.Rounds < 1)
        {
            throw new ArgumentException("settings without rounds; expected CcdSettings.Default or settings made by its constructor", nameof(settings));
        }

        int count = chain.Length;
        int end = chain[count - 1];
        float near = settings.Tolerance * length;
        float distance = Vec.Distance(model.Positions[end], target);
        float start = Vec.Distance(model.Positions[chain[0]], target);
        Span<Quaternion> best = count <= MaxOnStack ? stackalloc Quaternion[count] : new Quaternion[count];
        Span<float> gains = count <= MaxOnStack ? stackalloc float[count] : new float[count];
        gains.Fill(1f);
        JointChain.Keep(chain, local, best);
        float min = distance;
        bool newton = false;
        int stalled = 0;
        for (int round = 0; round < settings.Rounds && distance > near; round++)
        {
            float before = distance;
            if (newton)
            {
                LeastSquaresStep.Turn(skeleton, chain, target, length, settings.MaxTurn, gains, local, model);
            }
            else
            {
                for (int k = count - 2; k >= 0; k--)
                {
                    Turn(skeleton, chain, k, target, settings.MaxTurn, local, model);
                }
            }

            distance = Vec.Distance(model.Positions[end], target);
            if (distance < min)
            {
                min = distance;
                JointChain.Keep(chain, local, best);
            }

            stalled = distance > Stall * before ? stalled + 1 : 0;
            if (stalled >= 2 && distance > near && start <= length)
            {
                Bend(skeleton, chain, round, local, model);
                gains.Fill(1f);
                distance = Vec.Distance(model.Positions[end], target);
                newton = false;
                stalled = 0;
            }
            else
            {
                newton = newton ? distance < Slow * before : distance > Quick * before;
            }
        }

        JointChain.Restore(chain, best, local);
        Subtree.LocalToModel(skeleton, chain[0], local, model);
        distance = Vec.Distance(model.Positions[end], target);
        IkStatus failed = start > length ? IkStatus.TooFar : JointChain.IsAtLimit(skeleton, chain, local) ? IkStatus.Limited : IkStatus.NotConverged;
        return new IkResult(distance <= near ? IkStatus.Reached : failed, distance);
    }

    /// <summary>Bends the chain this way and that: out of a place that neither step leads out of, such as straight in line with the target.</summary>
    private static void Bend(Skeleton skeleton, ReadOnlySpan<int> chain, int round, in Pose local, in Pose model)
    {
        for (int k = 0; k < chain.Length - 1; k++)
        {
            Joint joint = skeleton.Joints[chain[k]];
            float angle = ((k + round) % 3) - 1f + (0.5f * ((round & 2) - 1));
            Vector3 axis = Rotation.Rotate(BoneAxes.Of(joint), (k & 1) == 0 || JointChain.IsHinge(joint.Limit) ? Vector3.UnitX : Vector3.UnitZ);
            Quaternion bent = Rotation.Normalize(Rotation.Multiply(local.Rotations[chain[k]], Rotation.FromAxisAngle(axis, Kick * angle)));
            local.Rotations[chain[k]] = SwingTwistLimit.ClampLocal(bent, joint);
        }

        for (int k = 0; k < chain.Length; k++)
        {
            Subtree.Place(skeleton.Parents[chain[k]], chain[k], local, model);
        }
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
        if (JointChain.IsHinge(limit))
        {
            Vector3 axis = Rotation.Rotate(BoneAxes.Of(about), Vector3.UnitX);
            from = Vec.Reject(from, axis);
            to = Vec.Reject(to, axis);
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
