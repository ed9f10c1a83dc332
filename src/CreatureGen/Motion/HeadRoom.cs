using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>Keeps two heads out of each other: who looks far aside has one snout at the other's cheek, and both necks lean away.</summary>
internal sealed class HeadRoom
{
    /// <summary>How often the necks give way in an update: turning away moves what is nearest.</summary>
    private const int Rounds = 3;

    /// <summary>Farthest that a neck leans away in a round, radians.</summary>
    private const float MostLean = 0.2f;

    private readonly Skeleton skeleton;
    private readonly (int Neck, CapsuleCollider Head) first;
    private readonly (int Neck, CapsuleCollider Head) second;
    private readonly float apart;

    private HeadRoom(Skeleton skeleton, (int Neck, CapsuleCollider Head) first, (int Neck, CapsuleCollider Head) second)
    {
        this.skeleton = skeleton;
        this.first = first;
        this.second = second;
        var rest = new Pose(skeleton.ModelRotations.ToArray(), skeleton.ModelPositions.ToArray());

        // As they are built they are where they should be.
        apart = Math.Min(first.Head.Radius + second.Head.Radius, Nearest(rest, out _, out _));
    }

    /// <summary>The room of two heads; null where one has no skin to bump into.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="bones">Around its bones.</param>
    /// <param name="first">The lowest joint of the first neck, and its head.</param>
    /// <param name="second">The same of the second.</param>
    public static HeadRoom? Of(Skeleton skeleton, IReadOnlyList<CapsuleCollider> bones, (int Neck, int Head) first, (int Neck, int Head) second)
    {
        CapsuleCollider? one = null;
        CapsuleCollider? other = null;
        foreach (CapsuleCollider bone in bones)
        {
            one = bone.Joint == first.Head ? bone : one;
            other = bone.Joint == second.Head ? bone : other;
        }

        return one == null || other == null ? null : new HeadRoom(skeleton, (first.Neck, one), (second.Neck, other));
    }

    /// <summary>Turns both necks so far that the heads do not touch.</summary>
    /// <param name="local">The pose; the lowest joints of both necks are turned.</param>
    /// <param name="model">The same in model space, brought up to date.</param>
    public void Keep(in Pose local, in Pose model)
    {
        for (int round = 0; round < Rounds; round++)
        {
            float distance = Nearest(model, out Vector3 one, out Vector3 other);
            if (distance >= apart)
            {
                return;
            }

            Vector3 away = Vec.Normalize(one - other, Vector3.UnitX) * ((apart - distance) / 2f);
            Lean(first.Neck, one, away, local, model);
            Lean(second.Neck, other, -away, local, model);
        }
    }

    /// <summary>Turns a neck so that a point of its head goes some way.</summary>
    private void Lean(int neck, Vector3 point, Vector3 way, in Pose local, in Pose model)
    {
        Vector3 lever = point - model.Positions[neck];
        Vector3 axis = Vec.Cross(lever, way);
        float across = Vec.Length(axis);
        float angle = Math.Min(across / Math.Max(Vec.LengthSquared(lever), 1e-12f), MostLean);
        if (angle <= 0f)
        {
            return;
        }

        Quaternion turned = Rotation.Multiply(Rotation.FromAxisAngle(axis / across, angle), model.Rotations[neck]);
        local.Rotations[neck] = SwingTwistLimit.ClampLocal(Rotation.Normalize(Rotation.Multiply(JointRelations.ParentInverse(skeleton, neck, model), turned)), skeleton.AllJoints[neck]);
        Subtree.LocalToModel(skeleton, neck, local, model);
    }

    /// <summary>How far the middles of both heads are from each other, and where they are nearest.</summary>
    private float Nearest(in Pose model, out Vector3 one, out Vector3 other)
    {
        (Vector3 a, Vector3 b) = Axis(first.Head, model);
        (Vector3 c, Vector3 d) = Axis(second.Head, model);
        float squared = SegmentDistance.Squared(a, b, c, d, out float s, out float t);
        one = Vec.Lerp(a, b, s);
        other = Vec.Lerp(c, d, t);
        return MathF.Sqrt(squared);
    }

    private static (Vector3 Start, Vector3 End) Axis(CapsuleCollider head, in Pose model)
    {
        Quaternion turn = model.Rotations[head.Joint];
        Vector3 place = model.Positions[head.Joint];
        return (place + Rotation.Rotate(turn, head.Start), place + Rotation.Rotate(turn, head.End));
    }
}
