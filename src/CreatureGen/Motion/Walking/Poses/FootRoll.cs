using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>The roll of a foot from heel to toe: its pitch through the cycle, and what that does to the ball's joint.</summary>
internal static class FootRoll
{
    /// <summary>Part of a stance in which the heel rises at least, as in a walk.</summary>
    private const float ShortestRise = 0.38f;

    /// <summary>The same at most, of feet that stand on their toes, which begin to roll as it does.</summary>
    private const float LongestRise = 0.42f;

    /// <summary>The same of flat feet, whose toes stay down at first.</summary>
    private const float LongestFlatRise = 0.50f;

    /// <summary>Part of the cycle that it takes to rise: in the short stances of a trot or gallop it begins early.</summary>
    private const float RiseOfCycle = 0.24f;

    /// <summary>Where in stance the sole is flat.</summary>
    private const float FlatFrom = 0.14f;

    /// <summary>Where in the swing the foot is pitched most.</summary>
    private const float PeakAt = 0.30f;

    /// <summary>Width in which heel and toe change places as pivots, radians.</summary>
    private const float PivotBlend = 0.2094f;

    /// <summary>Part of the swing at its beginning in which they begin to: in less the foot of a leg that has been near straight is thrown up, and its knee snaps.</summary>
    private const float PivotLeaving = 0.3f;

    /// <summary>The same at its end.</summary>
    private const float PivotArriving = 0.22f;

    /// <summary>Pitch beyond which toes leave the ground with the rest of a flat foot, radians.</summary>
    private const float ToeBreak = 0.3491f;

    /// <summary>Pitch over which they begin to, radians: at once they would throw the foot up.</summary>
    private const float ToeEasing = 0.5236f;

    /// <summary>Part of their pitch up to which feet on their toes roll off before a wall: they turn about the very tip then, which their skin does not do, and slide.</summary>
    private const float BeforeWall = 0.5f;

    /// <summary>Part of the pitch that toes off the ground make.</summary>
    private const float ToeFraction = 0.8f;

    /// <summary>Part of the swing in which it goes from there to how it comes down.</summary>
    private const float Levelling = 0.58f;

    /// <summary>Radians per second at which a foot rolls at most: in the short stances of a fast gallop toes roll off less far, and in short swings a foot is pitched and folded less.</summary>
    private const float FastestRoll = 20f;

    /// <summary>Greatest slope of the course of that over its part of the swing, and of that of a fold over all of it.</summary>
    private const float SmoothSlope = 1.5f;
    private const float FoldSlope = 4f;

    /// <summary>Speed backwards, of √(gℓ), from which on feet do not roll over their toes.</summary>
    private const float BackingSpeed = 0.14f;

    /// <summary>Activity from which on a foot takes on and gives up all its load from step to step.</summary>
    private const float SteppingActivity = 0.1f;

    /// <summary>Load of a foot that stands at rest.</summary>
    public const float RestLoad = 0.7f;

    /// <summary>How far feet roll at a speed, 0..1: who backs up comes down on the toes and leaves the ground with the whole sole.</summary>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="unit">Square of the speed of creatures of its size, gℓ.</param>
    public static float Going(float speed, float unit) => Scalar.Clamp(1f + (speed / (BackingSpeed * (float)Math.Sqrt(unit))), 0f, 1f);

    /// <summary>What a foot does at its place in the cycle.</summary>
    public static FootPosture At(in Foot foot, LegRig leg, in GaitNumbers gait) => new(
        Pitch(foot, leg, gait.Duty, gait.Cycle, gait.Swing) * gait.Roll,
        leg.Traits.Linkage == LegLinkage.Pantograph ? Fold(foot, leg.Traits, gait.Swing) * gait.Roll : 0f,
        foot.Phase == FootPhase.Swing ? 0f : Load(Math.Min(foot.Stance, 1f), gait.ForceDip, gait.Activity));

    /// <summary>Load of a foot in its stance, parts of its mean over the middle: sin πs + dip · sin 3πs of one that goes; one that stands has its share, which it takes on and gives up softly as soon as it steps.</summary>
    private static float Load(float stance, float dip, float activity)
    {
        FastTrigonometry.OfTurns(0.5f * stance, out float sine, out _);

        // sin 3x = 3 sin x − 4 sin³ x
        float force = Math.Max(0f, sine + (dip * ((3f * sine) - (4f * sine * sine * sine))));
        float taken = sine * (2f - sine);
        return Scalar.Lerp(RestLoad * Scalar.Lerp(1f, taken, Math.Min(activity / SteppingActivity, 1f)), force, activity);
    }

    /// <summary>Pitch of a foot, radians, toes down.</summary>
    /// <param name="foot">Its place in the cycle.</param>
    /// <param name="leg">Its build.</param>
    /// <param name="duty">Part of the cycle that it is down.</param>
    /// <param name="cycle">Seconds of the cycle.</param>
    /// <param name="swing">Seconds of a swing.</param>
    public static float Pitch(in Foot foot, LegRig leg, float duty, float cycle, float swing)
    {
        LegGaitParameters traits = leg.Traits;
        float rising = Scalar.Clamp(RiseOfCycle / Math.Max(duty, 0.1f), ShortestRise, leg.FlatFoot && !leg.Lateral ? LongestFlatRise : LongestRise);

        // Toes that hang over an edge have nothing to roll off: of a flat foot only the heel rises, about the ball.
        float most = traits.ToeOff * leg.RollFraction;
        if (foot.Plan.From.Overhangs)
        {
            most = leg.FlatFoot ? Math.Min(most, ToeBreak) : 0f;
        }
        else if (foot.Plan.From.MeetsWall && !leg.FlatFoot)
        {
            most *= BeforeWall;
        }

        float off = Math.Min(most, 0.5f * FastestRoll * rising * duty * cycle);
        float strike = Strike(foot, traits);
        if (foot.Phase == FootPhase.Stance)
        {
            float rise = Scalar.Clamp(1f - ((1f - foot.Stance) / rising), 0f, 1f);
            return (off * rise * rise) + (strike * (1f - Scalar.Smooth(foot.Stance / FlatFrom)));
        }

        float u = foot.Swing;
        float peak = Math.Min(traits.SwingPitch * leg.RollFraction, strike + (FastestRoll * Levelling * swing / SmoothSlope));
        if (u >= PeakAt)
        {
            return peak + ((strike - peak) * Scalar.Smooth((u - PeakAt) / Levelling));
        }

        // Hermite from the end of stance, with its rate, to the peak.
        float x = u / PeakAt;
        float rate = 2f * off / (rising * duty) * (1f - duty) * PeakAt;
        rate = Math.Min(rate, (3f * (peak - off)) + (0.5f * off));
        float y = 1f - x;
        return (off * (1f + (2f * x)) * y * y) + (rate * x * y * y) + (peak * x * x * (3f - (2f * x)));
    }

    /// <summary>By how much a foot that stands has rolled down since it came down, radians, toes down.</summary>
    public static float RolledDown(in Foot foot, LegRig leg) => -Strike(foot, leg.Traits) * Scalar.Smooth(foot.Stance / FlatFrom);

    /// <summary>Pitch at which a foot comes down, radians: all of its sole at once where that stands whole.</summary>
    private static float Strike(in Foot foot, LegGaitParameters traits) => traits.Strike * (1f - (foot.Phase == FootPhase.Stance ? foot.Plan.From.Whole : foot.Plan.To.Whole));

    /// <summary>Fold of the metatarsus beyond its link to the thigh, radians.</summary>
    /// <param name="foot">Its place in the cycle.</param>
    /// <param name="traits">Of its leg.</param>
    /// <param name="swing">Seconds that it is in the air.</param>
    public static float Fold(in Foot foot, LegGaitParameters traits, float swing)
    {
        if (foot.Phase == FootPhase.Stance)
        {
            return 0f;
        }

        float u = foot.Swing;
        float most = FastestRoll * swing / FoldSlope;
        return (Scalar.Clamp(traits.Fold, -most, most) * traits.FoldCurve.At(u)) + (traits.Unfold * Scalar.Smooth((u - 0.52f) / 0.28f) * (1f - Scalar.Smooth((u - 0.80f) / 0.20f)));
    }

    /// <summary>Pitch of what a foot stands on: the toes of a flat one, and all of others.</summary>
    public static float SolePitch(LegRig leg, float pitch) => leg.FlatFoot ? ToePitch(pitch) : pitch;

    /// <summary>Pitch of the toes of a flat foot, whose heel rises about the ball first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float ToePitch(float pitch)
    {
        if (pitch <= 0f)
        {
            return pitch;
        }

        float beyond = Math.Max(pitch - ToeBreak, 0f);
        return ToeFraction * (beyond < ToeEasing ? beyond * beyond / (2f * ToeEasing) : beyond - (0.5f * ToeEasing));
    }

    /// <summary>Place of the ball's joint from the point under the ball, in the foot's own axes, when the foot turns by a pitch about the tip of its toes (down) or its heel (up).</summary>
    /// <param name="leg">Gives the sole.</param>
    /// <param name="foot">In the swing the two pivots give way to one another gradually.</param>
    /// <param name="pitch">Radians.</param>
    public static Vector3 BallAt(LegRig leg, in Foot foot, float pitch)
    {
        float blend = foot.Phase == FootPhase.Stance ? 0f : PivotBlend * Scalar.Smooth(foot.Swing / PivotLeaving) * Scalar.Smooth((1f - foot.Swing) / PivotArriving);
        float root = (float)Math.Sqrt((pitch * pitch) + (blend * blend));
        if (root == 0f)
        {
            return new Vector3(0f, leg.BallHeight, 0f);
        }

        float down = 0.5f * (pitch + root);
        float up = 0.5f * (pitch - root);

        // In the plane of toes and up: x along the toes, y up; toes down turns up towards the toes.
        FastTrigonometry.SinCos(up, out float su, out float cu);
        float h = leg.BallHeight;

        // Before a wall it turns about the tip of its toes, and does not roll on into it.
        Vector2 over = (foot.Plan.From.MeetsWall ? new ToeTip(leg.Toe, 0f) : leg.Tip).BallAt(down, h);
        float along = over.X + ((leg.Heel * cu) - leg.Heel) + (h * su);
        float above = over.Y + ((-leg.Heel * su) + (h * cu)) - h;
        return (leg.ToeDirection * along) + new Vector3(0f, above, 0f);
    }
}
