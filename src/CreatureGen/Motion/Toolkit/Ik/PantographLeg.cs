using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A leg of three bones at rest, as <see cref="PantographIk"/> needs it.</summary>
public readonly struct PantographLeg
{
    /// <summary>Takes the bones as vectors in rest pose, model space, metres.</summary>
    /// <param name="thigh">From hip to knee (shoulder to elbow).</param>
    /// <param name="shank">From knee to ankle (elbow to wrist).</param>
    /// <param name="metatarsus">From ankle to ball.</param>
    /// <param name="hinge">Unit axis about which the shank turns as the knee folds.</param>
    /// <exception cref="ArgumentException">A number is not finite, or the hinge is not a unit vector.</exception>
    public PantographLeg(Vector3 thigh, Vector3 shank, Vector3 metatarsus, Vector3 hinge)
    {
        Finite.Require(thigh, nameof(thigh));
        Finite.Require(shank, nameof(shank));
        Finite.Require(metatarsus, nameof(metatarsus));
        if (!(Math.Abs(Vec.LengthSquared(hinge) - 1f) < 2f * Tolerance.UnitLength))
        {
            throw new ArgumentException(FormattableString.Invariant($"hinge = ({hinge.X}, {hinge.Y}, {hinge.Z}); expected a unit vector"), nameof(hinge));
        }

        Thigh = thigh;
        Shank = shank;
        Metatarsus = metatarsus;
        Hinge = hinge;
    }

    /// <summary>From hip to knee, metres.</summary>
    public Vector3 Thigh { get; }

    /// <summary>From knee to ankle, metres.</summary>
    public Vector3 Shank { get; }

    /// <summary>From ankle to ball, metres.</summary>
    public Vector3 Metatarsus { get; }

    /// <summary>Unit axis about which the shank turns as the knee folds.</summary>
    public Vector3 Hinge { get; }

    /// <summary>The leg of a skeleton.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="hip">Hip or shoulder.</param>
    /// <param name="knee">Knee or elbow; its hinge is read from its limits.</param>
    /// <param name="ankle">Ankle or wrist.</param>
    /// <param name="ball">Ball of the foot or hand.</param>
    /// <exception cref="ArgumentException">The joints are not a limb.</exception>
    public static PantographLeg Of(Skeleton skeleton, int hip, int knee, int ankle, int ball)
    {
        JointRelations.Require(skeleton, hip, knee);
        JointRelations.Require(skeleton, knee, ankle);
        JointRelations.Require(skeleton, ankle, ball);
        ReadOnlySpan<Vector3> p = skeleton.ModelPositions;
        Vector3 hinge = Rotation.Rotate(skeleton.ModelRotations[knee], HingeAxis.Of(skeleton.Joints[knee]));
        return new PantographLeg(p[knee] - p[hip], p[ankle] - p[knee], p[ball] - p[ankle], Vec.Normalize(hinge));
    }
}
