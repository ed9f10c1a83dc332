using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Brings the ball of a leg of three bones to a target. Thigh and metatarsus turn together, as two-joint muscles make them do in mammals, so the leg is exactly a leg of two bones; an extra fold
/// of the metatarsus draws the foot up in the swing. Closed form; nothing is allocated.
/// </summary>
/// <remarks>
/// With rest bones s₁, s₂, s₃, hinge n and fold ψ, the parts are a = s₁ + R(n, ψ) s₃ and b = s₂; the thigh turns by Q, the shank by Q · R(n, ε), the metatarsus by Q · R(n, ψ).
/// Based on: G. J. van Ingen Schenau, "From rotation to translation: constraints on multi-joint movements and the unique action of bi-articular muscles" (1989), for the coupling.
/// </remarks>
public static class PantographIk
{
    /// <summary>Solves for the turns of the three bones away from their rest in model space.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="target">Where the ball has to be, from the hip, model space, metres.</param>
    /// <param name="side">Where the hinge has to point: the hinge at rest, turned with pelvis and foot.</param>
    /// <param name="fold">ψ, radians about the hinge; 0 keeps the metatarsus parallel to its rest relative to the thigh.</param>
    /// <param name="reach">How far the knee stretches and folds.</param>
    /// <param name="thigh">Turn of the thigh.</param>
    /// <param name="shank">Turn of the shank.</param>
    /// <param name="metatarsus">Turn of the metatarsus.</param>
    /// <exception cref="System.ArgumentException">A number is not finite, or a part has no length across the hinge.</exception>
    /// <remarks>Written out where it is called: vectors that are handed over by value are put together by way of memory.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static IkResult Solve(in PantographLeg leg, Vector3 target, Vector3 side, float fold, in Reach reach, out Quaternion thigh, out Quaternion shank, out Quaternion metatarsus)
    {
        Finite.Require(target, nameof(target));
        Finite.Require(side, nameof(side));
        Finite.Require(fold, nameof(fold));
        Quaternion folding = Rotation.FromAxisAngle(leg.Hinge, fold);
        Vector3 a = leg.Thigh + Rotation.Rotate(folding, leg.Metatarsus);
        IkResult result = HingedLimb.Solve(a, leg.Shank, leg.Hinge, target, side, reach, out thigh, out shank);
        metatarsus = Rotation.Normalize(Rotation.Multiply(thigh, folding));
        return result;
    }

    /// <summary>Poses a leg of a skeleton, whatever its pose was.</summary>
    /// <param name="skeleton">Gives parents and rest pose.</param>
    /// <param name="hip">Hip or shoulder, the parent of the knee.</param>
    /// <param name="knee">Knee or elbow, the parent of the ankle.</param>
    /// <param name="ankle">Ankle or wrist.</param>
    /// <param name="leg">Of these joints, at rest.</param>
    /// <param name="target">Where the ball has to be, model space, metres.</param>
    /// <param name="side">Where the hinge has to point, model space.</param>
    /// <param name="fold">ψ, radians about the hinge.</param>
    /// <param name="reach">How far the knee stretches and folds.</param>
    /// <param name="local">Pose in the parents' space; hip, knee and ankle are turned.</param>
    /// <param name="model">The same in model space, up to date for the parent and place of the hip; brought up to date from the hip outwards.</param>
    /// <exception cref="System.ArgumentException">A pose is not as long as the skeleton, or a number is not finite.</exception>
    public static IkResult Apply(Skeleton skeleton, int hip, int knee, int ankle, in PantographLeg leg, Vector3 target, Vector3 side, float fold, in Reach reach, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        JointRelations.Require(skeleton, hip, knee);
        JointRelations.Require(skeleton, knee, ankle);
        IkResult result = Solve(leg, target - model.Positions[hip], side, fold, reach, out Quaternion thigh, out Quaternion shank, out Quaternion metatarsus);
        Quaternion thighModel = Rotation.Multiply(thigh, skeleton.ModelRotations[hip]);
        Quaternion shankModel = Rotation.Multiply(shank, skeleton.ModelRotations[knee]);
        Quaternion metatarsusModel = Rotation.Multiply(metatarsus, skeleton.ModelRotations[ankle]);
        local.Rotations[hip] = Rotation.Normalize(Rotation.Multiply(JointRelations.ParentInverse(skeleton, hip, model), thighModel));
        local.Rotations[knee] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(thighModel), shankModel));
        local.Rotations[ankle] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(shankModel), metatarsusModel));
        Subtree.LocalToModel(skeleton, hip, local, model);
        return result;
    }
}
