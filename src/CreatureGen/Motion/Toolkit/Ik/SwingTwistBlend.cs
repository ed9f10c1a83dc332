using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>
/// The way of a joint from one rotation to another by swing and twist: it is within the joint's limit where both its ends are. The shortest rotation between them need not be, and brought back within the limit it
/// jumps from one side of that to the other.
/// </summary>
internal static class SwingTwistBlend
{
    /// <summary>Where along the shortest way it is looked at, and how far outside its limit a joint may be there, radians.</summary>
    private const int Looks = 8;
    private const double Outside = 0.1;

    /// <summary>Whether the shortest way between two rotations within a joint's limit leads out of it.</summary>
    public static bool IsNeeded(Quaternion from, Quaternion to, Joint joint)
    {
        for (int i = 1; i < Looks; i++)
        {
            Quaternion shortest = Rotation.Slerp(from, to, (float)i / Looks);
            if (Rotation.AngleBetween(shortest, SwingTwistLimit.ClampLocal(shortest, joint)) > Outside)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>A rotation on the way.</summary>
    /// <param name="from">Where the way begins, in the parent's space.</param>
    /// <param name="to">Where it ends.</param>
    /// <param name="w">Part of the way, 0..1.</param>
    /// <param name="joint">Gives rest rotation and the axis of the bone.</param>
    public static Quaternion Between(Quaternion from, Quaternion to, float w, Joint joint)
    {
        if (from == to || w <= 0f || w >= 1f)
        {
            return w >= 1f ? to : from;
        }

        Quaternion own = BoneAxes.Of(joint);
        Quaternion axes = Rotation.Multiply(joint.LocalRotation, own);
        Quaternion inverse = Rotation.Inverse(axes);
        SwingTwistLimit.Split(Rotation.Multiply(inverse, Rotation.Multiply(from, own)), out double x, out double z, out double twist);
        SwingTwistLimit.Split(Rotation.Multiply(inverse, Rotation.Multiply(to, own)), out double toX, out double toZ, out double toTwist);
        Quaternion swing = SwingTwistLimit.Swing(Scalar.Lerp(x, toX, w), Scalar.Lerp(z, toZ, w));
        FastTrigonometry.SinCos((float)(0.5 * Scalar.Lerp(twist, toTwist, w)), out float sine, out float cosine);
        Quaternion turn = Rotation.Multiply(swing, new Quaternion(0f, sine, 0f, cosine));
        return Rotation.Normalize(Rotation.Multiply(axes, Rotation.Multiply(turn, Rotation.Inverse(own))));
    }
}
