using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Subjects;

/// <summary>The left limb of a pair of a skeleton from elsewhere, as the rig of grown creatures describes limbs. Lengths in metres; heights above the ground.</summary>
internal sealed class StandInLimb
{
    /// <summary>Height of the ankle, parts of the hip's, above which a foot stands on its toes: of two legs, and of more.</summary>
    private const float BipedToes = 0.3f;
    private const float Toes = 0.22f;

    /// <summary>How far outside its hip a foot is that stands out to the side, parts of the hip's height.</summary>
    private const float FarAside = 0.45f;

    /// <summary>How far the ball is ahead of the ankle, parts of the hip's height, below which a foot on its sole is that of a column.</summary>
    private const float ShortFoot = 0.11f;

    /// <summary>A foot of which no joint tells: how far its ball is ahead of the ankle and the tip of its toes ahead of that, parts of the hip's height, and how high it is, part of the ankle's.</summary>
    private const float BallAhead = 0.13f;
    private const float TipAhead = 0.07f;
    private const float BallHeight = 0.35f;

    /// <summary>Where the ball is of such a foot whose skin is known, part of the way from the ankle to the tip: near it, since all of the foot turns as one.</summary>
    private const float RigidBall = 0.8f;

    /// <summary>Shortest way from an ankle to the tip of its foot, and from the ball, parts of the hip's height.</summary>
    private const float ShortestFoot = 0.04f;
    private const float ShortestToes = 0.01f;

    /// <summary>Angle from where an arm hangs beyond which it is taken for one held out for binding, radians, and how far the elbow of such an arm bends then.</summary>
    private const double HeldOut = 0.5;
    private const double ElbowBend = 0.25;

    /// <summary>How an arm hangs: a little away from the body.</summary>
    private static readonly Vector3 hanging = new(0.14f, -0.99f, 0f);

    private StandInLimb(LimbPair pair, Vector3[] points)
    {
        Pair = pair;
        Points = points;
    }

    /// <summary>The joints of the skeleton from elsewhere.</summary>
    public LimbPair Pair { get; }

    /// <summary>Hip, knee, ankle, ball and end, as it stands in.</summary>
    public Vector3[] Points { get; }

    /// <summary>From how the skeleton holds the upper part at rest to how its stand-in does, and the same of all below it: arms that are held out hang.</summary>
    public Quaternion AlignUpper { get; private set; } = Quaternion.Identity;

    /// <inheritdoc cref="AlignUpper"/>
    public Quaternion AlignLower { get; private set; } = Quaternion.Identity;

    /// <summary>Whether the foot is out to the side of the hip.</summary>
    public bool Lateral => Math.Abs(Points[2].X - Points[0].X) > FarAside * Points[0].Y;

    /// <summary>Whether the foot stands on its sole and is hardly longer than the leg is thick: that of elephants.</summary>
    public bool IsColumn => !Lateral && Points[2].Y < Toes * Points[0].Y && Points[3].Z - Points[2].Z < ShortFoot * Points[0].Y;

    /// <summary>A leg that stands.</summary>
    /// <param name="pair">Its joints.</param>
    /// <param name="placeOf">Says where a joint is, above the ground.</param>
    /// <param name="reachOf">Says how far the skin of a joint and of what hangs on it reaches from the joint in a level direction; null where none is known.</param>
    public static StandInLimb Leg(LimbPair pair, Func<int, Vector3> placeOf, Func<int, Vector3, float?> reachOf)
    {
        Vector3[] p = Places(pair.Left, placeOf);
        float length = p[0].Y;
        float? foot = null;
        if (pair.Left[3] < 0)
        {
            foot = reachOf(pair.Left[2], Vector3.UnitZ) is float reach ? Math.Max(reach, ShortestFoot * length) : null;
            p[3] = new Vector3(p[2].X, BallHeight * p[2].Y, p[2].Z + (RigidBall * foot ?? BallAhead * length));
        }

        Vector3 ahead = new(p[3].X - p[2].X, 0f, p[3].Z - p[2].Z);
        Vector3 onward = Vec.Normalize(ahead, Vector3.UnitZ);
        float toes = (1f - RigidBall) * foot
            ?? (pair.Left[3] >= 0 && reachOf(pair.Left[3], onward) is float tip ? Math.Max(tip, ShortestToes * length) : Math.Max(TipAhead * length, 0.5f * Vec.Length(ahead)));
        p[4] = p[3] + (onward * toes);
        p[4].Y = 0.5f * p[3].Y;
        return new StandInLimb(pair, p);
    }

    /// <summary>An arm: brought down to hang if it is held out.</summary>
    public static StandInLimb Arm(LimbPair pair, Func<int, Vector3> placeOf)
    {
        Vector3[] p = Places(pair.Left, placeOf);
        if (pair.Left[3] < 0)
        {
            p[3] = p[2] + ((p[2] - p[1]) * 0.3f);
        }

        p[4] = p[3] + ((p[3] - p[2]) * 0.8f);
        var limb = new StandInLimb(pair, p);
        Vector3 along = Vec.Normalize(p[2] - p[0], hanging);
        if (Vec.Dot(along, hanging) < (float)PortableMath.Cos(HeldOut))
        {
            limb.LetHang();
        }

        return limb;
    }

    /// <summary>Its built form among legs that are no columns, which tells how it bends and steps.</summary>
    /// <param name="row">Number of its pair, 0 the hindmost.</param>
    /// <param name="rows">Number of pairs of legs.</param>
    public LimbArchetype ArchetypeOf(int row, int rows)
    {
        float heel = Points[2].Y / Points[0].Y;
        return Lateral ? (rows > 2 ? LimbArchetype.Insect : LimbArchetype.Sprawl)
            : rows == 1 ? (heel > BipedToes ? LimbArchetype.Theropod : LimbArchetype.PlantigradeHind)
            : row == 0 ? (heel > Toes ? LimbArchetype.DigitigradeHind : LimbArchetype.PlantigradeHind)
            : heel > Toes ? LimbArchetype.DigitigradeFore : LimbArchetype.PlantigradeFore;
    }

    private static Vector3[] Places(int[] joints, Func<int, Vector3> placeOf)
    {
        var points = new Vector3[5];
        for (int k = 0; k < 4; k++)
        {
            points[k] = joints[k] < 0 ? Vector3.Zero : placeOf(joints[k]);
        }

        return points;
    }

    private void LetHang()
    {
        Vector3 upper = Points[1] - Points[0];
        Vector3 lower = Points[2] - Points[1];
        Vector3 forearm = Rotation.Rotate(AxisRotation.Pitch(-ElbowBend), hanging);
        AlignUpper = Rotation.FromTo(upper, hanging);
        AlignLower = Rotation.Multiply(Rotation.FromTo(Rotation.Rotate(AlignUpper, lower), forearm), AlignUpper);
        Vector3 hand = Rotation.Rotate(AlignLower, Points[3] - Points[2]);
        Vector3 tip = Rotation.Rotate(AlignLower, Points[4] - Points[3]);
        Points[1] = Points[0] + Rotation.Rotate(AlignUpper, upper);
        Points[2] = Points[1] + Rotation.Rotate(AlignLower, lower);
        Points[3] = Points[2] + hand;
        Points[4] = Points[3] + tip;
    }
}

/// <summary>The joints of a limb and its mirror image: hip, knee, ankle, ball; −1 where there is no ball.</summary>
internal sealed record LimbPair(int[] Left, int[] Right);
