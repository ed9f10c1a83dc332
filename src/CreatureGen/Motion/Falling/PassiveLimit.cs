using System;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How far joints go without muscles: necks and backs bend and twist less than they do in motion, as ribs, ligaments and the flesh below them hold them.</summary>
internal static class PassiveLimit
{
    /// <summary>How far joints of the neck bend up and down, and to the sides, parts of how far they do with muscles.</summary>
    private const float Neck = 0.45f;
    private const float NeckAside = 0.5f;

    /// <summary>How far the whole of a back bends up and down, to the sides and about its length, degrees, and how many legs it carries at most: longer bodies bend as much for each so many. Every joint goes its share: as far as in motion, all of them would double a body over across the edge of a stair, and turn its chest onto the flank without its hips.</summary>
    private const double Back = 35;
    private const double BackAside = 45;
    private const double BackTwist = 28;
    private const double LegsOfBack = 4;

    /// <summary>The limits of the joints of a skeleton.</summary>
    /// <param name="skeleton">Whose.</param>
    /// <param name="legs">How many legs it has.</param>
    public static Func<Joint, JointLimit> Of(Skeleton skeleton, int legs)
    {
        int count = 0;
        foreach (Joint joint in skeleton.Joints)
        {
            count += IsBack(joint) ? 1 : 0;
        }

        double share = Math.Max(1, legs / LegsOfBack) / Math.Max(count, 1);
        var back = new JointLimit((float)Scalar.Radians(share * Back), (float)Scalar.Radians(share * BackAside), (float)Scalar.Radians(share * BackTwist));
        return joint => joint.Role is JointRole.Neck or JointRole.Head ? joint.Limit with { SwingX = Part(joint.Limit.SwingX, Neck), SwingZ = Part(joint.Limit.SwingZ, NeckAside) }
            : IsBack(joint) ? new JointLimit(Within(joint.Limit.SwingX, back.SwingX), Within(joint.Limit.SwingZ, back.SwingZ), Within(joint.Limit.Twist, back.Twist))
            : joint.Limit;
    }

    private static bool IsBack(Joint joint) => joint.Role is JointRole.Spine or JointRole.Chest;

    private static AngleRange Part(AngleRange range, float part) => new(part * range.Min, part * range.Max);

    private static AngleRange Within(AngleRange range, AngleRange other) => new(Math.Max(range.Min, other.Min), Math.Min(range.Max, other.Max));
}
