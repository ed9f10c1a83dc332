using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Brings the end of a chain of any number of joints to a target by laying its bones along straight lines, from the target inwards and from its root outwards in turn. Joints stay within their limits. Nothing is allocated.</summary>
/// <remarks>
/// <para>Forward and backward reaching: from the target inwards each joint is put on the line to the one before it, at the length of the bone between; from the root outwards each bone is then turned to where that puts its
/// end, and brought within the joint's limits at once (<see cref="SwingTwistLimit"/>), so that what follows hangs on what is possible. The best pose of all rounds is kept. Bends spread evenly over a free chain, which <see cref="CcdIk"/>
/// curls at its end; of chains with limits it reaches less. A chain that is straight in line with its target is bent a little first.</para>
/// <para>Based on: A. Aristidou and J. Lasenby, "FABRIK: A fast, iterative solver for the inverse kinematics problem" (2011).</para>
/// </remarks>
public static class FabrikIk
{
    /// <summary>Rounds that are usually enough.</summary>
    public const int UsualRounds = 16;

    private const int MaxOnStack = 64;

    /// <summary>Sideways, in lengths of the chain, by which joints of a chain are moved that lies in line with its target.</summary>
    private const float Aside = 0.02f;

    /// <summary>Poses a chain of a skeleton.</summary>
    /// <param name="skeleton">Gives parents, rest pose and limits.</param>
    /// <param name="chain">Joints from the first that turns to the end, which does not turn; each the parent of the next.</param>
    /// <param name="target">Where the end has to be, model space, metres.</param>
    /// <param name="rounds">Most rounds, at least 1; <see cref="UsualRounds"/>.</param>
    /// <param name="tolerance">Share of the chain's length within which the target counts as reached, above 0 to 1; 0.001 is usual.</param>
    /// <param name="local">Pose in the parents' space; the chain's joints but the last are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the first joint outwards.</param>
    /// <exception cref="ArgumentException">The joints are not a chain, a pose is not as long as the skeleton, there is no round, or a number is not finite.</exception>
    public static IkResult Apply(Skeleton skeleton, ReadOnlySpan<int> chain, Vector3 target, int rounds, float tolerance, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        Finite.Require(target, nameof(target));
        Finite.RequireWithin(tolerance, 1e-7f, 1f, nameof(tolerance));
        if (rounds < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(rounds), FormattableString.Invariant($"{rounds} rounds; expected at least 1"));
        }

        float length = JointChain.Prove(skeleton, chain, local);
        int count = chain.Length;
        float near = tolerance * length;
        float start = Vec.Distance(model.Positions[chain[0]], target);
        Span<Quaternion> best = count <= MaxOnStack ? stackalloc Quaternion[count] : new Quaternion[count];
        Span<Vector3> points = count <= MaxOnStack ? stackalloc Vector3[count] : new Vector3[count];
        JointChain.Keep(chain, local, best);
        float distance = Vec.Distance(model.Positions[chain[count - 1]], target);
        float min = distance;
        for (int round = 0; round < rounds && distance > near; round++)
        {
            Inwards(chain, target, round == 0 ? Aside * length : 0f, model, local, points);
            Outwards(skeleton, chain, points, local, model);
            distance = Vec.Distance(model.Positions[chain[count - 1]], target);
            if (distance < min)
            {
                min = distance;
                JointChain.Keep(chain, local, best);
            }
        }

        JointChain.Restore(chain, best, local);
        Subtree.LocalToModel(skeleton, chain[0], local, model);
        distance = Vec.Distance(model.Positions[chain[count - 1]], target);
        IkStatus failed = start > length ? IkStatus.TooFar : JointChain.IsAtLimit(skeleton, chain, local) ? IkStatus.Limited : IkStatus.NotConverged;
        return new IkResult(distance <= near ? IkStatus.Reached : failed, distance);
    }

    /// <summary>Puts the joints from the target inwards, each at the length of its bone from the one before.</summary>
    private static void Inwards(ReadOnlySpan<int> chain, Vector3 target, float aside, in Pose model, in Pose local, Span<Vector3> points)
    {
        int last = chain.Length - 1;
        Vector3 root = model.Positions[chain[0]];
        Vector3 line = target - root;
        bool straight = true;
        for (int k = 1; k <= last; k++)
        {
            straight &= Vec.LengthSquared(Vec.Cross(line, model.Positions[chain[k]] - root)) < 1e-6f * Vec.LengthSquared(line) * Vec.LengthSquared(model.Positions[chain[last]] - root);
        }

        Vector3 shift = straight ? Vec.Perpendicular(line) * aside : Vector3.Zero;
        points[last] = target;
        for (int k = last - 1; k >= 0; k--)
        {
            Vector3 from = model.Positions[chain[k]] + shift;
            points[k] = points[k + 1] + (Vec.Normalize(from - points[k + 1], Vector3.UnitY) * Vec.Length(local.Positions[chain[k + 1]]));
        }
    }

    /// <summary>Turns the bones from the root outwards towards where their ends were put; a hinge so that all that follows it comes nearest to where it was put.</summary>
    private static void Outwards(Skeleton skeleton, ReadOnlySpan<int> chain, ReadOnlySpan<Vector3> points, in Pose local, in Pose model)
    {
        for (int k = 0; k < chain.Length - 1; k++)
        {
            int joint = chain[k];
            Joint about = skeleton.Joints[joint];
            Quaternion inverse = Rotation.Inverse(model.Rotations[joint]);
            Quaternion turn = Quaternion.Identity;
            if (JointChain.IsHinge(about.Limit))
            {
                turn = HingeTurn(chain, k, Rotation.Rotate(BoneAxes.Of(about), Vector3.UnitX), inverse, points, model);
            }
            else
            {
                Vector3 to = Rotation.Rotate(inverse, points[k + 1] - model.Positions[joint]);
                turn = Vec.LengthSquared(local.Positions[chain[k + 1]]) > 1e-16f && Vec.LengthSquared(to) > 1e-16f ? Rotation.FromTo(local.Positions[chain[k + 1]], to) : turn;
            }

            local.Rotations[joint] = SwingTwistLimit.ClampLocal(Rotation.Normalize(Rotation.Multiply(local.Rotations[joint], turn)), about);
            for (int i = k; i < chain.Length; i++)
            {
                Subtree.Place(skeleton.Parents[chain[i]], chain[i], local, model);
            }
        }
    }

    /// <summary>The turn about an axis that brings what follows a joint, stiff as it is, nearest to the points in the mean of squares.</summary>
    private static Quaternion HingeTurn(ReadOnlySpan<int> chain, int k, Vector3 axis, Quaternion inverse, ReadOnlySpan<Vector3> points, in Pose model)
    {
        Vector3 place = model.Positions[chain[k]];
        float sine = 0f;
        float cosine = 0f;
        for (int i = k + 1; i < chain.Length; i++)
        {
            Vector3 from = Vec.Reject(Rotation.Rotate(inverse, model.Positions[chain[i]] - place), axis);
            Vector3 to = Vec.Reject(Rotation.Rotate(inverse, points[i] - place), axis);
            sine += Vec.Dot(axis, Vec.Cross(from, to));
            cosine += Vec.Dot(from, to);
        }

        return sine == 0f && cosine == 0f ? Quaternion.Identity : Rotation.FromAxisAngle(axis, PortableMath.Atan2(sine, cosine));
    }
}
