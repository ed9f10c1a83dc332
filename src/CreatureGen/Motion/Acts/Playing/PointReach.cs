using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>
/// Brings a point of the last joint of a chain to a target, from the root of the chain outwards and a part of the way at a time, so that bends spread over the chain; within limits. From pose to pose the
/// outcome is continuous: no step depends on how far another came.
/// </summary>
internal static class PointReach
{
    /// <summary>Joints of a chain that go only a share of the way; those beyond go all of it.</summary>
    private const int MaxChain = 64;

    private const int AimRounds = 4;
    private const int Rounds = 9;

    /// <summary>Part of the turn to the target that a joint makes at a time; in the last rounds nearly all of it.</summary>
    private const float Fraction = 0.45f;
    private const float LastFraction = 0.95f;

    /// <summary>Brings a head's point to a target, its snout pointing as wanted.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="tool">Mouth or brow.</param>
    /// <param name="target">Model space.</param>
    /// <param name="direction">Where the snout is to point, unit.</param>
    /// <param name="fraction">How far on the way, 0..1.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">The same in model space.</param>
    public static void Head(ActBody body, ActTool tool, Vector3 target, Vector3 direction, float fraction, in Pose local, in Pose model)
    {
        int[] chain = body.Bearers;
        int head = body.Head;
        Span<Quaternion> before = stackalloc Quaternion[MaxChain];
        Keep(chain, local, before);
        float length = Vec.Distance(body.Tools.PlaceOf(tool, false, model), model.Positions[head]);
        if (chain.Length > 1)
        {
            Vector3 joint = target - (direction * length);
            for (int round = 0; round < AimRounds; round++)
            {
                for (int k = 0; k < chain.Length - 1; k++)
                {
                    Turn(body.Skeleton, chain, k, model.Positions[head], joint, Fraction, local, model);
                }
            }

            Vector3 at = model.Positions[head];
            Turn(body.Skeleton, chain, chain.Length - 1, body.Tools.PlaceOf(tool, false, model), at + (direction * length), 1f, local, model);
        }

        for (int round = 0; round < Rounds; round++)
        {
            for (int k = 0; k < chain.Length; k++)
            {
                Turn(body.Skeleton, chain, k, body.Tools.PlaceOf(tool, false, model), target, round < Rounds / 2 ? Fraction : LastFraction, local, model);
            }
        }

        Blend(body.Skeleton, chain, before, fraction, local, model);
    }

    /// <summary>Brings the end of a chain to a target.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="chain">Joints from its root.</param>
    /// <param name="aim">What is brought.</param>
    /// <param name="target">Model space.</param>
    /// <param name="fraction">How far on the way, 0..1.</param>
    /// <param name="local">Pose in the parents' space.</param>
    /// <param name="model">The same in model space.</param>
    public static void Limb(ActBody body, int[] chain, in ActAim aim, Vector3 target, float fraction, in Pose local, in Pose model)
    {
        Span<Quaternion> before = stackalloc Quaternion[MaxChain];
        Keep(chain, local, before);
        for (int round = 0; round < Rounds; round++)
        {
            for (int k = 0; k < chain.Length; k++)
            {
                Turn(body.Skeleton, chain, k, body.Tools.PlaceOf(aim.Tool, aim.Mirrored, model), target, round < Rounds / 2 ? Fraction : LastFraction, local, model);
            }
        }

        Blend(body.Skeleton, chain, before, fraction, local, model);
    }

    private static void Keep(ReadOnlySpan<int> chain, in Pose local, Span<Quaternion> before)
    {
        for (int k = 0; k < Math.Min(chain.Length, MaxChain); k++)
        {
            before[k] = local.Rotations[chain[k]];
        }
    }

    /// <summary>Goes only a share of the way from how the chain was: joint by joint, so that its end goes in an arc and never through the body.</summary>
    private static void Blend(Skeleton skeleton, ReadOnlySpan<int> chain, ReadOnlySpan<Quaternion> before, float fraction, in Pose local, in Pose model)
    {
        for (int k = 0; k < Math.Min(chain.Length, MaxChain) && fraction < 1f; k++)
        {
            Quaternion mixed = UnitRotation.Nlerp(before[k], local.Rotations[chain[k]], fraction);
            local.Rotations[chain[k]] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(mixed), skeleton.AllJoints[chain[k]]);
        }

        Subtree.LocalToModel(skeleton, chain[0], local, model);
    }

    /// <summary>Turns one joint so that a point that hangs on it comes towards a goal; what is farther out in the chain goes along.</summary>
    private static void Turn(Skeleton skeleton, int[] chain, int k, Vector3 point, Vector3 goal, float fraction, in Pose local, in Pose model)
    {
        int joint = chain[k];
        Vector3 pivot = model.Positions[joint];
        Vector3 from = point - pivot;
        Vector3 to = goal - pivot;
        float lever = Vec.Length(from);
        float way = Vec.Length(to);
        if (!(lever * way > 1e-10f))
        {
            return;
        }

        // The direction to a goal close by swings round at a touch, and the way to one behind is to either side: the joints before this one bring the point there.
        float steady = Math.Min(1f, way / lever) * Math.Min(1f, 1f + (Vec.Dot(from, to) / (lever * way)));
        Quaternion whole = UnitRotation.FromTo(from / lever, to / way);
        Quaternion turn = UnitRotation.Nlerp(Quaternion.Identity, whole, fraction * steady);
        int parent = skeleton.Parents[joint];
        Quaternion turned = Rotation.Multiply(Rotation.Inverse(model.Rotations[parent]), Rotation.Multiply(turn, model.Rotations[joint]));
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(UnitRotation.Renormalize(turned), skeleton.AllJoints[joint]);
        for (int i = k; i < chain.Length; i++)
        {
            Subtree.Place(skeleton.Parents[chain[i]], chain[i], local, model);
        }
    }
}
