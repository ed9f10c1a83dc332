using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>
/// How far joints turn from their rest pose, by what they are: data in degrees, for the left side.
/// </summary>
/// <remarks>
/// <para>Signs follow <see cref="JointFrame"/>. Under the body, a positive turn about X swings a hanging bone backward and a foot's tip down: knees, carpi and fetlocks fold with
/// positive angles, elbows and hocks with negative ones; a positive turn about Z draws the limb in. Out to the side, a positive turn about X raises, a positive turn about Z sweeps back.</para>
/// <para>Four-footed legs: the ranges of motion of dogs (hip 50–162°, stifle 42–162°, tarsus 39–164°, shoulder 57–165°, elbow 36–165°, carpus 32–196°; G. Jaegger, D. Marcellin-Little and
/// D. Levine, "Reliability of goniometry in Labrador Retrievers", Am. J. Vet. Res. 63, 2002) less a standing dog's angles of about 115, 135, 135, 115, 138 and 180°, rounded to 5°.
/// The twist of their carpus is the forearm's, which has no joint of its own; that of a sprawler's ankle the shank's. Bears and uprights have human knees and ankles, their feet
/// turn sole in and out by the AMA's 30 and 20°; the carpus of plantigrade forefeet bends aside like a human wrist, by 30° outward and 20° inward (American Academy of Orthopaedic Surgeons, 1965), twists as in dogs,
/// and folds farther than a wrist and less far than a dog's. The ball of hoofed feet stands for fetlock, pastern and coffin joint: the latter two alone give 8° aside and 9° of twist (H. M. Clayton, D. H. Sha,
/// J. A. Stick and P. Robinson, "3D kinematics of the interphalangeal joints in the forelimb of walking and trotting horses", 2007). The rest is set to what their gaits need with a margin.</para>
/// <para>Neck and tail: the thesis's rule that a chain of n bones bends by 200°/n at most in each, so that it looks natural while its sum stays near 100°.
/// Bodies that move by waves hold several bends one way and the other: 480°/n.</para>
/// </remarks>
internal static class JointLimits
{
    private const double BendPerChain = 200;
    private const double BendPerUndulatingChain = 480;
    private const double MaxPerBone = 60;
    private const double SkinStretch = 0.64;

    // Shoulder, elbow, wrist, hand: the elbow folds forward, the wrist back. The shoulder twists from a blade that hangs at rest.
    private static readonly short[] wing = { -80, 85, -45, 125, -40, 80, -60, 40, -165, 25, -45, 45, -60, 40, -25, 170, -45, 45, -50, 40, -25, 60, -45, 45 };

    private static readonly short[] pelvis = { -40, 40, -35, 35, -30, 30 };
    private static readonly short[] spine = { -20, 20, -25, 25, -15, 15 };
    private static readonly short[] chest = { -30, 30, -30, 30, -20, 20 };
    private static readonly short[] head = { -45, 55, -60, 60, -40, 40 };
    private static readonly short[] jaw = { -22, 40, -4, 4, -3, 3 };
    private static readonly short[] eye = { -25, 25, -35, 35, -10, 10 };
    private static readonly short[] fin = { -70, 70, -70, 70, -75, 75 };
    private static readonly short[] finTip = { -45, 45, -30, 30, -35, 35 };
    private static readonly short[] insectWing = { -100, 100, -110, 60, -95, 95 };
    private static readonly short[] ear = { -50, 50, -50, 50, -70, 70 };
    private static readonly short[] antenna = { -60, 60, -60, 60, -30, 30 };

    /// <summary>Limits of a joint of a leg or arm.</summary>
    public static JointLimit Leg(LimbArchetype archetype, JointRole role)
    {
        LegLimits limits = LegKinds.Of(archetype).Limits;
        JointRange range = role switch
        {
            JointRole.Hip => limits.Hip,
            JointRole.Knee => limits.Knee,
            JointRole.Ankle => limits.Ankle,
            JointRole.Ball => limits.Ball,
            _ => throw new ArgumentOutOfRangeException(nameof(role), role, "expected hip, knee, ankle or ball"),
        };
        return new JointLimit(RangeOf(range.SwingX), RangeOf(range.SwingZ), RangeOf(range.Twist));
    }

    /// <summary>Limits of a joint of a stitched wing, 0 shoulder to 3 hand.</summary>
    public static JointLimit Wing(int joint) => Row(wing, Math.Min(joint, 3));

    /// <summary>Limits of a joint of a fin, ear, antenna or insect wing, 0 the root.</summary>
    public static JointLimit Soft(JointRole role, int joint) => role switch
    {
        JointRole.Fin => Row(joint == 0 ? fin : finTip, 0),
        JointRole.Ear => Row(ear, 0),
        JointRole.Antenna => Row(antenna, 0),
        JointRole.Wing => Row(joint == 0 ? insectWing : finTip, 0),
        _ => throw new ArgumentOutOfRangeException(nameof(role), role, "expected fin, ear, antenna or wing"),
    };

    /// <summary>Limits of a joint of trunk and head.</summary>
    public static JointLimit Body(JointRole role) => role switch
    {
        JointRole.Root or JointRole.Body => JointLimit.Free,
        JointRole.Pelvis => Row(pelvis, 0),
        JointRole.Spine => Row(spine, 0),
        JointRole.Chest => Row(chest, 0),
        JointRole.Head => Row(head, 0),
        JointRole.Jaw => Row(jaw, 0),
        JointRole.Eye => Row(eye, 0),
        _ => throw new ArgumentOutOfRangeException(nameof(role), role, "expected a joint of trunk or head"),
    };

    /// <summary>Limits of a joint of a neck, a tail or the body of a swimmer: a chain of so many bones.</summary>
    public static JointLimit Chain(int bones)
    {
        float bend = (float)Scalar.Radians(Math.Min(BendPerChain / Math.Max(bones, 1), MaxPerBone));
        return new JointLimit(bend, bend, bend / 2);
    }

    /// <summary>Limits of a joint of a body that moves by waves (swimmers, snakes), a chain of so many bones: it bends to both sides at once, so that its sum stays small where each bone bends far.</summary>
    public static JointLimit Undulating(int bones)
    {
        float bend = (float)Scalar.Radians(Math.Min(BendPerUndulatingChain / Math.Max(bones, 1), MaxPerBone));
        return new JointLimit(bend, bend, bend / 4);
    }

    /// <summary>
    /// A limit of a bend of the body, narrowed so that the skin on the inner side of the bend does not fold: half the girth there may turn by no more than
    /// 0.64 of the shorter of the two bones that meet (the steepest part of the stretch over which the skin goes over from one to the other).
    /// </summary>
    /// <param name="limit">The limit to narrow.</param>
    /// <param name="bone">Length of the shorter bone.</param>
    /// <param name="shape">The sections.</param>
    /// <param name="ring">Where the body bends.</param>
    public static JointLimit WithinGirth(JointLimit limit, float bone, BodyShape shape, double ring)
    {
        float Bend(double[] extent) => (float)(SkinStretch * bone / Math.Max(BodyShape.At(extent, ring), 1e-3));
        float up = Bend(shape.Top);
        float down = Bend(shape.Bottom);
        float side = Bend(shape.Width);
        float max = Math.Min(up, down);
        return new JointLimit(
            new AngleRange(Math.Max(limit.SwingX.Min, -max), Math.Min(limit.SwingX.Max, max)),
            new AngleRange(Math.Max(limit.SwingZ.Min, -side), Math.Min(limit.SwingZ.Max, side)),
            limit.Twist);
    }

    private static JointLimit Row(short[] degrees, int row)
    {
        AngleRange Range(int column) => RangeOf((degrees[(6 * row) + column], degrees[(6 * row) + column + 1]));
        return new JointLimit(Range(0), Range(2), Range(4));
    }

    private static AngleRange RangeOf((int Min, int Max) degrees) => new((float)Scalar.Radians(degrees.Min), (float)Scalar.Radians(degrees.Max));
}
