using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>A standing leg as the walk needs it: joints, rest places, sole. Model space, metres.</summary>
internal sealed class LegRig
{
    private readonly LegSegments parts;
    private readonly LegLimits limits;

    /// <summary>Part of the reach that a step may take up.</summary>
    private const float Stretch = 0.97f;

    private const float LateralStretch = 0.92f;

    /// <summary>Lowering of the body beyond its crouch that long steps may cost, leg lengths.</summary>
    private const float MaxDrop = 0.05f;

    /// <summary>Slope on which they may cost none, and beyond which the legs keep room to spare: what one girdle comes down there pitches the trunk farther.</summary>
    private const float SteepestDrop = 0.25f;

    /// <summary>Part of the stance behind its middle at which the heel has begun to rise and gives length.</summary>
    private const float RearEnd = 0.40f;

    /// <summary>How high the ball rises at most as the foot rolls over the tip of its toes, leg lengths: on the long toes of raptors and ducks a full roll would fold the leg up.</summary>
    private const float HighestRoll = 0.16f;

    /// <summary>How far legs out to the side sweep ahead and back (tan 36°).</summary>
    private const float SweepTangent = 0.72f;

    /// <summary>Part of its reach that a leg out to the side takes up at most under a body that goes.</summary>
    private const float GoingStretch = 0.88f;

    /// <summary>Part of its distance from the hip, level, to which a foot is drawn in at most.</summary>
    private const float MaxGathering = 0.6f;

    /// <summary>Part of what its hip turns to either side that a leg under the body takes up at most as its foot comes down: the rest is for the roll of the body.</summary>
    private const float LandingFraction = 0.85f;

    /// <summary>Height of a foot's middle as it goes past the other, part of the height to which its ball is lifted: its toes hang.</summary>
    private const float PassingHeight = 1.3f;

    /// <summary>Least factor on the distance of the tracks of legs out to the side.</summary>
    private const float LateralTrack = 0.9f;

    /// <summary>Part of its chord at rest to which a leg is tucked.</summary>
    private const float TuckedFraction = 0.6f;

    /// <summary>How far back a tucked leg is laid, leg lengths.</summary>
    private const float TuckedBack = 0.25f;

    /// <summary>Part of its reach to which a leg is stretched that trails behind.</summary>
    private const float TrailedFraction = 0.96f;

    /// <summary>How far aside and down a leg out to the side trails, parts of how far behind.</summary>
    private const float TrailedAside = 0.30f;

    private const float TrailedDown = -0.25f;

    /// <summary>How near its hip a foot goes past it that turns along with its leg, part of its distance from there at rest.</summary>
    private const float NearestSweep = 0.35f;

    /// <summary>Where a leg under the body trails.</summary>
    private static readonly Vector3 TrailedUpright = new(0f, -0.75f, -0.65f);

    /// <summary>Sine of a bend at rest that says nothing of the side to which a knee folds.</summary>
    private const float Straight = 0.1f;

    public LegRig(Skeleton skeleton, LimbChain chain, int row, int trunkSlot, SoleExtent sole, IReadOnlyList<CapsuleCollider> bones)
    {
        Girdle = chain.Joints[0];
        Hip = chain.Joints[1];
        Knee = chain.Joints[2];
        Ankle = chain.Joints[3];
        Ball = chain.Joints[4];
        End = chain.Joints[5];
        Pair = chain.Pair;
        Row = row;
        Side = chain.Side;
        TrunkSlot = trunkSlot;
        Traits = LegGaitParameters.Of(chain.Archetype!.Value);
        ReadOnlySpan<Vector3> p = skeleton.ModelPositions;
        HipRest = p[Hip];
        Home = new Vector3(p[Ball].X, 0f, p[Ball].Z);
        BallHeight = p[Ball].Y;
        Thigh = p[Knee] - p[Hip];
        Shank = p[Ankle] - p[Knee];
        Metatarsus = p[Ball] - p[Ankle];
        Length = Vec.Distance(HipRest, Home);
        PostureSeconds = PostureFade.SecondsOf(Length);
        Lateral = Traits.Kind.Build.Posture == LimbPosture.Splayed;
        FlatFoot = Traits.FlatFoot;

        // A foot out to the side rolls over the tip of its own toes.
        Vector3 toes = p[End] - p[Ball];
        toes.Y = 0f;
        Vector3 ahead = Vec.Normalize(toes, Vector3.UnitZ);
        Follows = Traits.Kind.Outline.Arched;
        ToeDirection = Follows ? Vec.Normalize(new Vector3(Home.X - HipRest.X, 0f, Home.Z - HipRest.Z), Vector3.UnitZ) : ahead.Z < 0.3f ? Vector3.UnitZ : ahead;
        RollAxis = Vec.Cross(Vector3.UnitY, ToeDirection);
        Toe = Math.Max(sole.Toe, 0.02f * Length);
        Heel = Math.Max(sole.Heel, 0.02f * Length);
        Tip = sole.Tip;
        Fore = Math.Max(sole.Fore, Toe);
        Aft = Math.Max(sole.Aft, Heel);
        HalfWidth = sole.HalfWidth;
        Breadth = WidestOf(bones);
        double tip = Scalar.Clamp(HighestRoll * Length / Toe, 0, 1);
        RollFraction = FlatFoot ? 1f : Math.Min(1f, (float)PortableMath.Asin(tip) / Traits.ToeOff);
        SoleMiddle = new Vector3(sole.Middle.X, 0f, sole.Middle.Z);
        Hinder = sole.Hinder;
        Sole = Array.ConvertAll(sole.Outline, place => place - new Vector3(0f, BallHeight, 0f));
        Hinge = Vec.Normalize(Rotation.Rotate(skeleton.ModelRotations[Knee], Vector3.UnitX));
        Vector3 upper = Traits.Linkage == LegLinkage.Pantograph ? Thigh + Metatarsus : Thigh;
        Vector3 across = Vec.Normalize(Vec.Cross(upper + Shank, Vector3.UnitY), Hinge);
        AcrossSign = Vec.Dot(across, Hinge) < 0f ? -1f : 1f;
        Skew = Hinge - (across * AcrossSign);
        KneeRest = skeleton.Joints[Knee].LocalRotation;
        limits = new LegLimits(skeleton, Side, Hip, Knee, Ankle, Ball, Traits.Linkage == LegLinkage.Pantograph);
        Vector3 a = Vec.Reject(upper, Hinge);
        Vector3 b = Vec.Reject(Shank, Hinge);
        float turn = Vec.Dot(Vec.Cross(a, b), Hinge);
        AngleRange fold = skeleton.Joints[Knee].Limit.SwingX;
        bool straight = Math.Abs(turn) < Straight * Vec.Length(a) * Vec.Length(b);
        BendSign = straight || Traits.Linkage == LegLinkage.Pantograph ? (fold.Max >= -fold.Min ? 1 : -1) : turn >= 0f ? 1 : -1;
        double bend = BendSign * PortableMath.Atan2(turn, Vec.Dot(a, b));
        double straightens = BendSign > 0 ? -fold.Min : fold.Max;
        MinBendCosine = PortableMath.Cos(Math.Max(BendRange.Min, bend - straightens));
        parts = new LegSegments(upper, Shank, Hinge, MinBendCosine);
        LandsIn = AsideRange(limits.DrawsIn * LandingFraction);
        LandsOut = AsideRange(limits.DrawsOut * LandingFraction);
        double la = Vec.Length(a);
        double lb = Vec.Length(b);
        Reach = (float)Math.Sqrt((la * la) + (lb * lb) + (2 * la * lb * MinBendCosine));
        RestStretch = Vec.Length(upper + Shank) / Reach;
        double folds = BendSign > 0 ? fold.Max : -fold.Min;
        FoldedReach = (float)Math.Sqrt(parts.OffsetSquared + Math.Max(0, (la * la) + (lb * lb) + (2 * la * lb * PortableMath.Cos(Math.Min(BendRange.Max, bend + folds)))));
        float stoop = 0f;
        Gathered = Lateral ? Gather(out stoop) : Home;
        Stoop = stoop;
        MinTrack = Math.Max(NarrowestTrack(), ThighTrack(skeleton, bones));
        Tucked = ((upper + Shank) * TuckedFraction) - new Vector3(0f, 0f, TuckedBack * Length);
        Vector3 behind = Lateral ? new Vector3(Side == Side.Left ? TrailedAside : -TrailedAside, TrailedDown, -1f) : TrailedUpright;
        Trailed = Vec.Normalize(behind, -Vector3.UnitZ) * (TrailedFraction * Reach);
    }

    /// <summary>How far beside its hip the leg brings its foot when it is turned aside, metres: what stays on the ground below it does not lean along.</summary>
    /// <param name="angle">Radians, below a right angle.</param>
    public float AsideRange(float angle) => -(parts.Upper + Shank).Y * (float)(PortableMath.Sin(angle) / PortableMath.Cos(angle));

    private float WidestOf(IReadOnlyList<CapsuleCollider> bones)
    {
        float max = 0f;
        foreach (CapsuleCollider bone in bones)
        {
            max = bone.Joint == Knee || bone.Joint == Ankle || bone.Joint == Ball ? Math.Max(max, bone.Radius) : max;
        }

        return max;
    }

    /// <summary>Legs out to the side stay there, and the hip draws in a foot only so far.</summary>
    private float NarrowestTrack()
    {
        float min = 1f - (Traits.MaxAdduction * HipRest.Y / Math.Max(Math.Abs(Gathered.X), 1e-4f));
        return Lateral ? Math.Max(min, LateralTrack) : min;
    }

    /// <summary>Thick thighs come no nearer to the middle than lets them go past each other: a foot that is drawn in takes its knee along.</summary>
    private float ThighTrack(Skeleton skeleton, IReadOnlyList<CapsuleCollider> bones)
    {
        float room = float.MaxValue;
        foreach (CapsuleCollider bone in bones)
        {
            if (bone.Joint == Hip)
            {
                float start = HipRest.X + Rotation.Rotate(skeleton.ModelRotations[Hip], bone.Start).X;
                float end = HipRest.X + Rotation.Rotate(skeleton.ModelRotations[Hip], bone.End).X;
                room = Math.Max(0f, Math.Min(room, Math.Min(Math.Abs(start), Math.Abs(end)) - bone.Radius));
            }
        }

        float knee = -Thigh.Y / Math.Max(HipRest.Y, 1e-4f);
        return Lateral ? 0f : Math.Min(1f, 1f - (room / Math.Max(knee * Math.Abs(Home.X), 1e-4f)));
    }

    /// <summary>Where the foot goes: drawn in towards the hip when the leg stands nearly stretched; and how far the body comes down for it where that is not enough.</summary>
    private Vector3 Gather(out float stoop)
    {
        Vector3 chord = Thigh + Shank;
        float reach = GoingStretch * Reach;
        float level = (float)Math.Sqrt((chord.X * chord.X) + (chord.Z * chord.Z));
        float height = -chord.Y;
        float max = (float)Math.Sqrt(Math.Max((reach * reach) - (height * height), 0f));
        float fraction = Scalar.Clamp(max / Math.Max(level, 1e-6f), MaxGathering, 1f);
        float aside = fraction * level;
        stoop = fraction > MaxGathering ? 0f : Math.Max(0f, height - (float)Math.Sqrt(Math.Max((reach * reach) - (aside * aside), 0f)));
        return new Vector3(Home.X - ((1f - fraction) * chord.X), 0f, Home.Z - ((1f - fraction) * chord.Z));
    }

    /// <summary>Factor on the distance of its track from the middle: no less than the hip allows, and than lets left and right feet go past each other.</summary>
    /// <param name="asked">By the gait.</param>
    /// <param name="lift">Height of a foot that goes past one that stands, as a factor on that of the leg's build; 0 where both may be in the air.</param>
    public float Track(float asked, float lift)
    {
        float aside = Math.Max(Math.Abs(Gathered.X), 1e-4f);
        float apart = Math.Min(Breadth, aside);
        float over = 0.5f * PassingHeight * Traits.Lift * lift * Length;
        float beside = (float)Math.Sqrt(Math.Max((apart * apart) - (over * over), 0f));
        return Math.Max(asked, Math.Max(MinTrack, beside / aside));
    }

    /// <summary>The longest way that the foot can go along the ground in a stance before the leg reaches too far, metres.</summary>
    /// <param name="steps">How it steps.</param>
    public float LongestStance(in LegSteps steps)
    {
        bool pantograph = Traits.Linkage == LegLinkage.Pantograph;
        Vector3 rest = Thigh + Shank + (pantograph ? Metatarsus : Vector3.Zero);
        float drop = ((steps.Crouch + (Lateral ? 0.012f : MaxDrop * (1f - (Math.Abs(steps.Slope) / SteepestDrop)))) * Length) + Stoop;
        rest += steps.Home - Home;
        float height = Math.Max(-rest.Y - drop, 0.2f * Length);
        float aside = Lateral ? rest.X : rest.X + ((steps.Track - 1f) * Home.X);
        float fraction = Lateral ? LateralStretch : Stretch;
        float room = Math.Max((fraction * fraction * Reach * Reach) - (height * height) - (aside * aside), 0.01f * Length * Length);

        // The foot of a sprawler is set down ahead of its hip, not of its home.
        float middle = (Traits.Kind.Outline.Sprawling ? 0.06f * Length : rest.Z) + steps.Shift;
        float goes = Math.Max(1f - steps.Slide, 0.3f);
        float ahead = (Level(room, height, steps.Slope) - middle) / Math.Max((0.5f + steps.Bias) * goes, 0.05f);
        float rear = Traits.Kind.Outline.Arched ? 0.5f : RearEnd;
        float behind = (Level(room, height, -steps.Slope) + middle) / Math.Max((rear - steps.Bias) * goes, 0.05f);
        float max = Math.Min(ahead, behind);
        if (Lateral)
        {
            float away = (float)Math.Sqrt(((steps.Home.X - HipRest.X) * (steps.Home.X - HipRest.X)) + ((steps.Home.Z - HipRest.Z) * (steps.Home.Z - HipRest.Z)));
            max = Math.Min(max, 2f * SweepTangent * away / Math.Max(1f - (2f * steps.Yaw), 0.4f));
        }

        return Math.Max(max, 0.1f * Length);
    }

    /// <summary>How far from below the hip the leg reaches the ground that rises there by a slope: d² + (h − sd)² = h² + room.</summary>
    private static float Level(float room, float height, float slope)
    {
        float steep = 1f + (slope * slope);
        float rise = height * slope;
        return (rise + (float)Math.Sqrt((rise * rise) + (steep * room))) / steep;
    }

    /// <summary>Whether it is in the rear half of the rows, which carries the pelvis.</summary>
    /// <param name="rows">Number of pairs of legs.</param>
    public bool IsHind(int rows) => Row * 2 < rows;

    public int Girdle { get; }

    public int Hip { get; }

    public int Knee { get; }

    public int Ankle { get; }

    public int Ball { get; }

    public int End { get; }

    /// <summary>Number of the pair from the front, 1 the foremost.</summary>
    public int Pair { get; }

    /// <summary>Number of the pair from the rear, 0 the rearmost.</summary>
    public int Row { get; }

    public Side Side { get; }

    /// <summary>The trunk joint that carries it, as a place in the trunk's chain.</summary>
    public int TrunkSlot { get; }

    public LegGaitParameters Traits { get; }

    /// <summary>Whether it stands out to the side.</summary>
    public bool Lateral { get; }

    /// <summary>Whether the whole sole is on the ground: the heel rises first, about the ball.</summary>
    public bool FlatFoot { get; }

    public Vector3 HipRest { get; }

    /// <summary>Point on the ground under the ball.</summary>
    public Vector3 Home { get; }

    /// <summary>The same under a body that goes: drawn in towards the hip where the leg stands nearly stretched at rest.</summary>
    public Vector3 Gathered { get; }

    /// <summary>How far the body comes down as it goes, so that a leg that stands nearly stretched has room to step, metres.</summary>
    public float Stoop { get; }

    /// <summary>From the hip to what is solved for of a leg tucked to the body.</summary>
    public Vector3 Tucked { get; }

    /// <summary>The same of a leg that is stretched out behind.</summary>
    public Vector3 Trailed { get; }

    /// <summary>Height of the ball's joint above the ground.</summary>
    public float BallHeight { get; }

    public Vector3 Thigh { get; }

    public Vector3 Shank { get; }

    public Vector3 Metatarsus { get; }

    /// <summary>The two parts that are solved for, the metatarsus not folded.</summary>
    public ref readonly LegSegments Parts => ref parts;

    /// <summary>From the hip to the ground under the ball.</summary>
    public float Length { get; }

    /// <summary>Seconds in which its foot goes over to another posture where that does not follow on the last.</summary>
    public float PostureSeconds { get; }

    /// <summary>Level unit direction in which the toes point.</summary>
    public Vector3 ToeDirection { get; }

    /// <summary>Axis of the foot's roll: a positive turn puts the toes down.</summary>
    public Vector3 RollAxis { get; }

    /// <summary>From the ball to the tip of the toes, level.</summary>
    public float Toe { get; }

    /// <summary>The end of the toes over which the foot rolls off the ground.</summary>
    public ToeTip Tip { get; }

    /// <summary>Share of the roll over its toes that the foot makes: less on long toes.</summary>
    public float RollFraction { get; }

    /// <summary>From the ball back to the heel, level.</summary>
    public float Heel { get; }

    /// <summary>How far the foot reaches ahead of the ball and behind it above its sole, too, as high as what it may run against, metres.</summary>
    public float Fore { get; }

    /// <inheritdoc cref="Fore"/>
    public float Aft { get; }

    /// <summary>From the middle of the sole to its sides, level.</summary>
    public float HalfWidth { get; }

    /// <summary>Radius of the widest part below the knee.</summary>
    public float Breadth { get; }

    /// <summary>Least factor on the distance of its track from the middle that the hip allows.</summary>
    public float MinTrack { get; }

    /// <summary>What its joints let it do.</summary>
    public ref readonly LegLimits Limits => ref limits;

    /// <summary>How far towards the middle from beside its hip the foot of a leg below it comes down at most, and how far away from it, metres.</summary>
    public float LandsIn { get; }

    /// <inheritdoc cref="LandsIn"/>
    public float LandsOut { get; }

    /// <summary>From the ball to the middle of the sole, level.</summary>
    public Vector3 SoleMiddle { get; }

    /// <summary>From the ball to the outline of the sole at rest, all round it, metres.</summary>
    public Vector3[] Sole { get; }

    /// <inheritdoc cref="SoleExtent.Hinder"/>
    public int Hinder { get; }

    /// <summary>Whether its foot turns along as the leg is swept, on the middle of its sole: that of claws.</summary>
    public bool Follows { get; }

    /// <summary>How far the leg is swept about the vertical with its foot at a place, from rest: one that comes near to its hip is taken for one that goes past it outside.</summary>
    /// <param name="place">Model space; its height does not count.</param>
    public Quaternion Sweep(Vector3 place)
    {
        var rest = new Vector3(Home.X - HipRest.X, 0f, Home.Z - HipRest.Z);
        var swept = new Vector3(place.X - HipRest.X, 0f, place.Z - HipRest.Z);
        float length = Vec.Length(rest);
        float outward = Vec.Dot(swept, rest) / length;
        float along = ((swept.Z * rest.X) - (swept.X * rest.Z)) / length;
        return Rotation.FromTo(rest, swept + (rest * ((PastHip.Out(outward, along, NearestSweep * length) - outward) / length)));
    }

    /// <summary>Axis about which knee and metatarsus turn.</summary>
    public Vector3 Hinge { get; }

    /// <summary>Of legs out to the side: whether the hinge points along the product of leg and up, or against it.</summary>
    public float AcrossSign { get; }

    /// <summary>What the hinge of a leg out to the side is off that product at rest.</summary>
    public Vector3 Skew { get; }

    /// <summary>Local rotation of the knee at rest; its own X is the hinge.</summary>
    public Quaternion KneeRest { get; }

    /// <summary>Sign of the knee's bend about the hinge.</summary>
    public int BendSign { get; }

    /// <summary>Cosine of the knee's bend at its straightest: nearly straight, or where its limit ends.</summary>
    public double MinBendCosine { get; }

    /// <summary>Greatest distance that the two solved parts span, the knee at its straightest.</summary>
    public float Reach { get; }

    /// <summary>Part of that reach that the leg takes up at rest.</summary>
    public float RestStretch { get; }

    /// <summary>Least distance from the hip to their end, folded as far as the knee's limit goes.</summary>
    public float FoldedReach { get; }
}
