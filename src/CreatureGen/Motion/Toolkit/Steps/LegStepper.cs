using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Steps;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Lets feet step after a body that moves in any way: a foot that is too far from its home steps to it and a little beyond, in a curve, while the feet of its group may step and those of other groups stand.
/// Needs nothing of a skeleton but its homes; a leg follows its foot by <see cref="TwoBoneIk"/> or <see cref="CcdIk"/>. Nothing is allocated.
/// </summary>
/// <remarks>
/// <para>The curve is a quadratic Bézier through lift-off and touch-down whose middle lies above the middle of both by twice the lift; the foot goes along it with an eased start and end. Touch-down is where a ray from above
/// the goal meets the ground; without ground there is no step.</para>
/// <para>Groups take turns: while a foot of one is in the air, no other begins; when all stand, the group with the foot farthest from its home begins, another one than before if it wants to as well.</para>
/// <para>In a gait feet leave the ground and come down when their phases say, as those of grown creatures do: each where its home will be in the middle of the stance to come.</para>
/// <para>Based on: WeaverDev, "Making Bonehead" (2018), with the direction to the home at unit length, so that the overshoot is a length.</para>
/// </remarks>
public static class LegStepper
{
    /// <summary>Lets time pass.</summary>
    /// <param name="feet">The feet.</param>
    /// <param name="groups">The group of each: feet of one group step together. A trot has two, diagonal pairs.</param>
    /// <param name="homes">Where each foot would be at rest under the body as it is now; world space, metres.</param>
    /// <param name="settings">When and how they step.</param>
    /// <param name="ground">What they step on.</param>
    /// <param name="up">Unit, away from the ground.</param>
    /// <param name="seconds">Time since the last call.</param>
    /// <param name="turn">The group that stepped last; −1 to begin with.</param>
    /// <exception cref="ArgumentNullException">There is no ground.</exception>
    /// <exception cref="ArgumentException">There is not one group and one home for each foot, settings were not made by their constructor, or a number is not finite.</exception>
    public static void Update(Span<SteppingFoot> feet, ReadOnlySpan<int> groups, ReadOnlySpan<Vector3> homes, in LegStepSettings settings, IGround ground, Vector3 up, float seconds, ref int turn)
    {
        _ = ground ?? throw new ArgumentNullException(nameof(ground));
        Finite.RequireStep(seconds);
        Finite.Require(up, nameof(up));
        if (groups.Length != feet.Length || homes.Length != feet.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{groups.Length} groups and {homes.Length} homes; expected one of each for {feet.Length} feet"), nameof(homes));
        }

        if (!(settings.Duration > 0f))
        {
            throw new ArgumentException("settings without a duration; expected settings made by their constructor", nameof(settings));
        }

        bool stepping = false;
        for (int i = 0; i < feet.Length; i++)
        {
            Finite.Require(homes[i], nameof(homes));
            Advance(ref feet[i], settings, up, seconds);
            stepping |= feet[i].IsStepping;
        }

        if (!stepping)
        {
            turn = Next(feet, groups, homes, settings, turn);
        }

        for (int i = 0; i < feet.Length; i++)
        {
            if (groups[i] == turn && !feet[i].IsStepping && Vec.Distance(feet[i].Position, homes[i]) > settings.Distance)
            {
                Begin(ref feet[i], homes[i], settings, ground, up);
            }
        }
    }

    /// <summary>Lets feet step by the phases of a gait instead of by distance.</summary>
    /// <param name="feet">The feet.</param>
    /// <param name="lags">When in the cycle each comes down, parts of a cycle: a trot has 0 and 0.5 for its diagonal pairs.</param>
    /// <param name="phase">Place in the cycle now; the caller lets it go on by time over <see cref="StepGait.Seconds"/>, and only its fraction counts.</param>
    /// <param name="gait">How long a cycle lasts, and what part of it feet are down.</param>
    /// <param name="homes">Where each foot would be at rest under the body as it is now; world space, metres.</param>
    /// <param name="velocity">Of the body; world space, metres per second.</param>
    /// <param name="settings">Lift and reach as by distance; feet that are nearer than <see cref="LegStepSettings.Distance"/> to their next place stay down. Duration and overshoot follow from the gait.</param>
    /// <param name="ground">What they step on.</param>
    /// <param name="up">Unit, away from the ground.</param>
    /// <exception cref="ArgumentNullException">There is no ground.</exception>
    /// <exception cref="ArgumentException">There is not one lag and one home for each foot, settings or gait were not made by their constructors, or a number is not finite.</exception>
    public static void UpdateInGait(Span<SteppingFoot> feet, ReadOnlySpan<float> lags, float phase, in StepGait gait, ReadOnlySpan<Vector3> homes, Vector3 velocity, in LegStepSettings settings, IGround ground, Vector3 up)
    {
        _ = ground ?? throw new ArgumentNullException(nameof(ground));
        Finite.Require(phase, nameof(phase));
        Finite.Require(velocity, nameof(velocity));
        Finite.Require(up, nameof(up));
        if (lags.Length != feet.Length || homes.Length != feet.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{lags.Length} lags and {homes.Length} homes; expected one of each for {feet.Length} feet"), nameof(homes));
        }

        if (!(settings.Distance > 0f) || !(gait.Seconds > 0f))
        {
            throw new ArgumentException("settings or a gait without numbers; expected those made by their constructors", nameof(gait));
        }

        for (int i = 0; i < feet.Length; i++)
        {
            Finite.Require(homes[i], nameof(homes));
            float swing = StepPhase.Swing(StepPhase.Place(phase, lags[i]), gait.Duty);
            if (swing >= 0f)
            {
                float flight = (1f - swing) * (1f - gait.Duty) * gait.Seconds;
                Swing(ref feet[i], swing, homes[i] + (velocity * StepPhase.ToMidstance(flight, gait.Duty, gait.Seconds)), settings, ground, up);
            }
            else if (feet[i].IsStepping)
            {
                feet[i].Progress = 1f;
                feet[i].Position = feet[i].To;
            }
        }
    }

    private static void Swing(ref SteppingFoot foot, float swing, Vector3 goal, in LegStepSettings settings, IGround ground, Vector3 up)
    {
        bool begins = !foot.IsStepping;
        if (begins && (swing > StepPhase.LatestLift || Vec.Length(Vec.Reject(goal - foot.Position, up)) <= settings.Distance))
        {
            return;
        }

        if (begins || swing < StepPhase.Frozen)
        {
            if (!Find(ref foot, goal, settings, ground, up) && begins)
            {
                return;
            }
        }

        if (begins)
        {
            foot.From = foot.Position;
            foot.LiftAt = swing;
        }

        foot.Progress = (swing - foot.LiftAt) / (1f - foot.LiftAt);
        foot.Position = OnItsWay(foot, StepPhase.Along(foot.Progress), settings.Lift, up);
    }

    private static void Advance(ref SteppingFoot foot, in LegStepSettings settings, Vector3 up, float seconds)
    {
        if (!foot.IsStepping)
        {
            return;
        }

        foot.Progress = Math.Min(foot.Progress + (seconds / settings.Duration), 1f);
        if (!foot.IsStepping)
        {
            foot.Position = foot.To;
            return;
        }

        foot.Position = OnItsWay(foot, Scalar.Smooth(foot.Progress), settings.Lift, up);
    }

    /// <summary>A place on the curve of a step.</summary>
    private static Vector3 OnItsWay(in SteppingFoot foot, float fraction, float lift, Vector3 up)
    {
        Vector3 above = (foot.From + foot.To) * 0.5f + (up * (2f * lift * Vec.Distance(foot.From, foot.To)));
        return Vec.Lerp(Vec.Lerp(foot.From, above, fraction), Vec.Lerp(above, foot.To, fraction), fraction);
    }

    private static int Next(ReadOnlySpan<SteppingFoot> feet, ReadOnlySpan<int> groups, ReadOnlySpan<Vector3> homes, in LegStepSettings settings, int turn)
    {
        int next = turn;
        float farthest = settings.Distance;
        bool other = false;
        for (int i = 0; i < feet.Length; i++)
        {
            float far = Vec.Distance(feet[i].Position, homes[i]);
            bool another = groups[i] != turn;
            if (far > settings.Distance && ((another && !other) || (another == other && far > farthest)))
            {
                (next, farthest, other) = (groups[i], far, another);
            }
        }

        return next;
    }

    private static void Begin(ref SteppingFoot foot, Vector3 home, in LegStepSettings settings, IGround ground, Vector3 up)
    {
        Vector3 towards = Vec.Normalize(Vec.Reject(home - foot.Position, up), Vector3.Zero);
        Vector3 goal = home + (towards * (settings.Distance * settings.Overshoot));
        if (Find(ref foot, goal, settings, ground, up))
        {
            foot.From = foot.Position;
            foot.Progress = 0f;
        }
    }

    /// <summary>Sets where a foot comes down; whether there is ground.</summary>
    private static bool Find(ref SteppingFoot foot, Vector3 goal, in LegStepSettings settings, IGround ground, Vector3 up)
    {
        bool found = ground.Cast(goal + (up * settings.Reach), -up, 2f * settings.Reach, out GroundHit hit);
        if (found)
        {
            foot.To = hit.Point;
            foot.Normal = hit.Normal;
        }

        return found;
    }
}
