using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The axis about which a joint folds, read from its limits: knees about local X, elbows of wings about local Z, in the direction in which they turn farthest.</summary>
public static class HingeAxis
{
    /// <summary>Square of the sine of a bend below which a limb counts as straight.</summary>
    private const float Straight = 3e-4f;

    /// <summary>Unit axis in the joint's own space, whatever axis its bone lies along; a turn about it by a positive angle folds the joint.</summary>
    public static Vector3 Of(Joint joint) => BoneAxes.AreOwn(joint) ? Of(joint.Limit) : Rotation.Rotate(BoneAxes.Of(joint), Of(joint.Limit));

    /// <summary>Unit axis in the axes of the bone (<see cref="BoneAxes"/>); a turn about it by a positive angle folds the joint.</summary>
    public static Vector3 Of(JointLimit limit)
    {
        float min = -limit.SwingX.Min;
        float max = limit.SwingX.Max;
        Vector3 axis = max >= min ? Vector3.UnitX : -Vector3.UnitX;
        float widest = max >= min ? max : min;
        if (-limit.SwingZ.Min > widest)
        {
            axis = -Vector3.UnitZ;
            widest = -limit.SwingZ.Min;
        }

        return limit.SwingZ.Max > widest ? Vector3.UnitZ : axis;
    }

    /// <summary>The axis in model space about which a limb folds as it lies: the hinge of its limits; of a middle joint that turns any way that of its bend, of a straight one across its pole.</summary>
    internal static Vector3 OfLimb(Joint middle, Quaternion middleModel, Vector3 upper, Vector3 lower, Vector3 pole)
    {
        if (middle.Limit != JointLimit.Free)
        {
            return Rotation.Rotate(middleModel, Of(middle));
        }

        Vector3 bend = Vec.Cross(upper, lower);
        if (Vec.LengthSquared(bend) > Straight * Vec.LengthSquared(upper) * Vec.LengthSquared(lower))
        {
            return Vec.Normalize(bend);
        }

        Vector3 chord = upper + lower;
        return Vec.Normalize(Vec.Cross(pole, chord), Vec.Perpendicular(Vec.Normalize(chord, Vector3.UnitY)));
    }
}
