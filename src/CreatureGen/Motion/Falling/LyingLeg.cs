using System;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Falling;

/// <summary>A leg of a body on the ground, which comes to stand again.</summary>
internal sealed class LyingLeg
{
    private LyingLeg(LegRig rig)
    {
        Rig = rig;
        Parts = new LegSegments(rig.Thigh, rig.Shank, rig.Hinge, rig.MinBendCosine);
    }

    /// <summary>The leg as its walk sees it.</summary>
    public LegRig Rig { get; }

    /// <summary>What goes from the hip to the ankle.</summary>
    public LegSegments Parts { get; }

    /// <summary>Whether it is out to the side.</summary>
    public bool Lateral => Rig.Lateral;

    /// <summary>Those of a creature; none of who has no legs.</summary>
    public static LyingLeg[] Of(LeggedBody? body) => Array.ConvertAll(body?.Legs ?? [], leg => new LyingLeg(leg));
}
