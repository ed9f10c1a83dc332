using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Winged;

/// <summary>
/// Wings of what goes on its legs alone. Feathers are folded onto the flanks where it stands, and raised half open as it goes; membranes, which are rags on a flank, are always raised, but where it lies down on them.
/// Either are spread to be seen. Immutable, worked out once.
/// </summary>
internal sealed class CarriedWings
{
    /// <summary>How far they are asked to be down from where on they fold: who only cowers lowers them.</summary>
    private const float Folding = 0.5f;

    /// <summary>How much it goes from where on they are raised all the way.</summary>
    private const float FullyGoing = 0.5f;

    private readonly WingPair[] pairs;
    private readonly bool alwaysRaised;
    private readonly (int Joint, Quaternion Rotation, Vector3 Position)[] folded;

    private CarriedWings(Skeleton skeleton, WingPair[] pairs, IReadOnlyList<PairedChain> chains, bool alwaysRaised)
    {
        this.pairs = pairs;
        this.alwaysRaised = alwaysRaised;
        var local = new Pose(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);
        local.SetToRest(skeleton);
        foreach (WingPair pair in pairs)
        {
            pair.Write(local, default);
        }

        var joints = new List<(int, Quaternion, Vector3)>();
        foreach (PairedChain chain in chains)
        {
            for (int k = 0; k <= chain.Count; k++)
            {
                int left = chain.Limb.Joints[k];
                int right = skeleton.Mirrors[left];
                joints.Add((left, local.Rotations[left], local.Positions[left]));
                joints.Add((right, local.Rotations[right], local.Positions[right]));
            }
        }

        folded = joints.ToArray();
    }

    /// <summary>The wings that a body on legs carries; null for what has none, or has them on its flanks as it was grown.</summary>
    public static CarriedWings? Of(LeggedBody body)
    {
        MotionSubject subject = body.Subject;
        var chains = new List<PairedChain>();
        foreach (LimbChain limb in subject.Limbs)
        {
            if (subject.Kind == LocomotionKind.Walking && SpreadWings.Is(subject.Skeleton, limb) && PairedChain.Of(subject.Skeleton, limb) is PairedChain chain)
            {
                chains.Add(chain);
            }
        }

        if (chains.Count == 0)
        {
            return null;
        }

        var room = new FoldRoom(subject, body.Posture, AxialChain.Of(subject.Skeleton, subject.Bones).Length);
        return new CarriedWings(subject.Skeleton, WingPair.Folded(subject, chains, subject.HasMembranes ? FoldRange.CarriedMembranes : FoldRange.CarriedFeathers, room), chains, subject.HasMembranes);
    }

    /// <summary>Writes their joints.</summary>
    /// <param name="shown">How far they are spread and raised to be seen, 0..1, or beyond to raise them higher; lowered below 0, and folded at −1.</param>
    /// <param name="going">How much it goes, 0 standing to 1.</param>
    /// <param name="sway">How they swing with the body.</param>
    /// <param name="local">Receives the joints, in the parents' space.</param>
    public void Write(float shown, float going, in WingSway sway, in Pose local)
    {
        float raised = alwaysRaised ? 1f : (float)Scalar.Smooth(going / FullyGoing);
        raised *= 1f - (float)Scalar.Smooth((-shown - Folding) / (1f - Folding));
        float spread = Scalar.Clamp(shown, 0f, 1f);
        if (spread > 0f || raised > 0f)
        {
            var stroke = new WingStroke { Spread = Math.Max(spread, raised), Carried = 1f - spread, Shown = shown, LiftLeft = sway.Left, LiftRight = sway.Right };
            foreach (WingPair pair in pairs)
            {
                pair.Write(local, stroke);
            }

            return;
        }

        foreach ((int joint, Quaternion rotation, Vector3 position) in folded)
        {
            local.Rotations[joint] = rotation;
            local.Positions[joint] = position;
        }

        foreach (WingPair pair in pairs)
        {
            pair.Rest(local, sway.Left, sway.Right);
        }
    }
}
