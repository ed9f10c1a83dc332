using System;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>What poses and masks have to be, and the messages when they are not.</summary>
internal static class PoseCheck
{
    /// <summary>Throws unless two poses have the same number of joints.</summary>
    public static void SameLength(in Pose a, in Pose b)
    {
        if (a.Rotations.Length != b.Rotations.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"poses of {a.Rotations.Length} and {b.Rotations.Length} joints; expected poses of one skeleton"));
        }
    }

    /// <summary>Throws unless a mask is empty or has one weight per joint.</summary>
    public static void Mask(ReadOnlySpan<float> mask, int joints)
    {
        if (!mask.IsEmpty && mask.Length != joints)
        {
            throw new ArgumentException(FormattableString.Invariant($"a mask of {mask.Length} weights; expected {joints}, one per joint, or none"), nameof(mask));
        }
    }

    /// <summary>The error of a joint whose weight, rotation or position is not finite.</summary>
    public static ArgumentException NotFinite(int joint) =>
        new(FormattableString.Invariant($"a weight, rotation or position of joint {joint} is not finite; expected unit quaternions and metres"));

    /// <summary>Throws with the first number of the mask or pose that is not finite.</summary>
    public static void Refuse(in Pose pose, ReadOnlySpan<float> mask)
    {
        for (int i = 0; i < pose.Rotations.Length; i++)
        {
            if (!mask.IsEmpty && !Finite.Is(mask[i]))
            {
                throw new ArgumentException(FormattableString.Invariant($"mask[{i}] = {mask[i]}; expected a finite weight"), nameof(mask));
            }

            // What was too large to be brought to unit length has become nought.
            if (!Finite.Is(pose.Rotations[i]) || pose.Rotations[i] == default)
            {
                throw new ArgumentException(FormattableString.Invariant($"the rotation of joint {i} is not finite; expected unit quaternions"));
            }

            if (!Finite.Is(pose.Positions[i]))
            {
                throw new ArgumentException(FormattableString.Invariant($"the position of joint {i} is not finite; expected metres"));
            }
        }
    }
}
