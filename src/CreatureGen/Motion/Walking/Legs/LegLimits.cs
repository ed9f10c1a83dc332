using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>What the joints of a leg let it do, side by side in memory as a leg asks for them. Fields, so that what is asked of one is not asked of a copy.</summary>
internal readonly struct LegLimits
{
    /// <summary>How far the plane of a leg turns with its foot at least.</summary>
    public const float LeastFootShare = 0.25f;

    /// <summary>Half the yaw of a body over a foot that stands, radians, as it turns on the spot.</summary>
    private const float FootYaw = 0.225f;

    /// <summary>Limits and rest of hip, ankle and ball.</summary>
    public readonly LocalLimit Hip;
    public readonly LocalLimit Ankle;
    public readonly LocalLimit Ball;

    /// <summary>How far the knee turns from rest.</summary>
    public readonly FoldLimit Knee;

    /// <summary>How far the ankle folds from rest.</summary>
    public readonly AngleRange AnkleRange;

    /// <summary>Turn of the ankle from rest at its limit on the side to which it folds farther.</summary>
    public readonly Quaternion AnkleFold;

    /// <summary>Local rotation of the ankle there.</summary>
    public readonly Quaternion AnkleFolded;

    /// <summary>How far the plane of a leg below its body turns with its foot about the vertical, 0..1. The rest an ankle has to twist that carries its foot by itself: pillars do so little that their feet would be turned along with the body.</summary>
    public readonly float FootShare;

    /// <summary>How far the ankle twists to either side, radians.</summary>
    public readonly float AnkleTwist;

    /// <summary>How far the ankle bends to either side, radians.</summary>
    public readonly float AnkleAside;

    /// <summary>How far the hip draws the leg in towards the middle, and away from it, radians.</summary>
    public readonly float DrawsIn;
    public readonly float DrawsOut;

    /// <summary>Those of a leg whose ankle carries its foot by itself, or that is linked.</summary>
    public LegLimits(Skeleton skeleton, Side side, int hip, int knee, int ankle, int ball, bool linked)
    {
        Hip = new LocalLimit(skeleton.Joints[hip]);
        Ankle = new LocalLimit(skeleton.Joints[ankle]);
        Ball = new LocalLimit(skeleton.Joints[ball]);
        Knee = new FoldLimit(skeleton.Joints[knee].Limit.SwingX);
        AnkleRange = skeleton.Joints[ankle].Limit.SwingX;
        AnkleFold = Rotation.FromAxisAngle(Vector3.UnitX, AnkleRange.Max > -AnkleRange.Min ? AnkleRange.Max : AnkleRange.Min);
        AnkleFolded = Rotation.Multiply(skeleton.Joints[ankle].LocalRotation, AnkleFold);
        AngleRange twist = skeleton.Joints[ankle].Limit.Twist;
        AnkleTwist = Math.Min(twist.Max, -twist.Min);
        AngleRange across = skeleton.Joints[ankle].Limit.SwingZ;
        AnkleAside = Math.Min(across.Max, -across.Min);
        FootShare = linked ? LeastFootShare : Math.Max(LeastFootShare, 1f - (AnkleTwist / FootYaw));
        AngleRange aside = skeleton.Joints[hip].Limit.SwingZ;
        (DrawsIn, DrawsOut) = side == Side.Left ? (aside.Max, -aside.Min) : (-aside.Min, aside.Max);
    }
}
