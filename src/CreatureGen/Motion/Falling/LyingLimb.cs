using System;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Falling;

/// <summary>A leg of a body on the ground: on its way to where it belongs it would go through the ground.</summary>
internal sealed class LyingLimb
{
    /// <summary>Number of joints of a limb.</summary>
    public const int JointCount = 3;

    private LyingLimb(LegRig leg)
    {
        Leg = leg;
        Joints = [leg.Hip, leg.Knee, leg.Ankle];
        Parts = new LegSegments(leg.Thigh, leg.Shank, leg.Hinge, leg.MinBendCosine);
    }

    /// <summary>The leg.</summary>
    public LegRig Leg { get; }

    /// <summary>Hip, knee and ankle.</summary>
    public int[] Joints { get; }

    /// <summary>What goes from the hip to the ankle.</summary>
    public LegSegments Parts { get; }

    /// <summary>How it gives way to the ground.</summary>
    public LimbYield Yield => Lateral ? LimbYield.Lateral : LimbYield.Under;

    /// <summary>Metres.</summary>
    public float Length => Leg.Length;

    /// <summary>Whether it is out to the side.</summary>
    public bool Lateral => Leg.Lateral;

    /// <summary>Those of a creature; none of who has no legs.</summary>
    public static LyingLimb[] Of(LeggedBody? body) => Array.ConvertAll(body?.Legs ?? [], leg => new LyingLimb(leg));
}
