using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Clips;

/// <summary>How many frames a second a recording takes: quick wings would strobe at the usual rate.</summary>
internal static class ClipRate
{
    private const int Highest = 240;

    /// <summary>Most that a joint may turn from frame to frame, radians; about twelve frames make a beat of a wing.</summary>
    private const float FarthestTurn = 0.5f;

    /// <summary>Whether a recording at a rate is to be made anew at twice that rate.</summary>
    public static bool IsTooLow(int rate, float farthestTurn) => farthestTurn > FarthestTurn && rate < Highest;

    /// <summary>Records at the usual rate, and at twice the rate before as long as joints turn too far.</summary>
    /// <param name="skeleton">Of the clips.</param>
    /// <param name="record">Makes a recording at a rate.</param>
    public static Clip Record(Skeleton skeleton, Func<int, Clip> record)
    {
        int rate = Clip.UsualRate;
        Clip clip = record(rate);
        while (IsTooLow(rate, Farthest(skeleton, clip)))
        {
            rate *= 2;
            clip = record(rate);
        }

        return clip;
    }

    /// <summary>The farthest that a joint turns from one frame to the next, radians. A blink is a matter of a frame or two and does not count.</summary>
    private static float Farthest(Skeleton skeleton, Clip clip)
    {
        float min = 1f;
        for (int frame = 1; frame < clip.Frames; frame++)
        {
            min = Math.Min(min, MinDot(skeleton, clip.RotationsAt(frame - 1), clip.RotationsAt(frame)));
        }

        return 2f * (float)PortableMath.Acos(min);
    }

    /// <summary>Cosine of half the angle by which the joint that turns farthest turns between two poses, lids left out.</summary>
    public static float MinDot(Skeleton skeleton, ReadOnlySpan<Quaternion> before, ReadOnlySpan<Quaternion> after)
    {
        float min = 1f;
        for (int joint = 0; joint < before.Length; joint++)
        {
            if (skeleton.Joints[joint].Role != JointRole.Lid)
            {
                min = Math.Min(min, Math.Abs(SimdKernels.Dot(before[joint], after[joint])));
            }
        }

        return min;
    }
}
