using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Subjects;

/// <summary>Tells wings that stand out to the side at rest from those that lie along the flank as they were grown.</summary>
internal static class SpreadWings
{
    /// <summary>How far out a wing goes at the least, relative to its length from root to tip: those along the flank go out by less than half of that.</summary>
    private const float MinOutward = 0.55f;

    /// <summary>Whether a body has any.</summary>
    public static bool Of(MotionSubject subject)
    {
        foreach (LimbChain limb in subject.Limbs)
        {
            if (Is(subject.Skeleton, limb))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Whether a limb is a stitched wing that is spread at rest.</summary>
    public static bool Is(Skeleton skeleton, LimbChain limb)
    {
        if (limb.Kind != LimbKind.Wing)
        {
            return false;
        }

        Vector3 way = skeleton.ModelPositions[limb.Joints[limb.Joints.Count - 1]] - skeleton.ModelPositions[limb.Joints[0]];
        return Math.Abs(way.X) > MinOutward * Vec.Length(way);
    }
}
