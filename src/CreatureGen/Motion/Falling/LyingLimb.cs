using System.Collections.Generic;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Falling;

/// <summary>A leg out to the side of a body on the ground: on its way to where it stands it would go through the ground.</summary>
/// <param name="Joints">Hip, knee and ankle.</param>
/// <param name="Length">Metres.</param>
internal readonly record struct LyingLimb(int[] Joints, float Length)
{
    /// <summary>Number of joints of a limb.</summary>
    public const int JointCount = 3;

    /// <summary>Those of a creature; none of who has no legs.</summary>
    public static LyingLimb[] Of(LeggedBody? body)
    {
        var limbs = new List<LyingLimb>();
        foreach (LegRig leg in body?.Legs ?? [])
        {
            if (leg.Lateral)
            {
                limbs.Add(new LyingLimb([leg.Hip, leg.Knee, leg.Ankle], leg.Length));
            }
        }

        return limbs.ToArray();
    }
}
