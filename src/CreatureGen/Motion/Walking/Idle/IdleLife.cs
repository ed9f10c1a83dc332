using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Idle;

/// <summary>What a standing creature does: it breathes, shifts its weight and rests a hind foot, sways its tail, in the rhythm of its size.</summary>
internal static class IdleLife
{
    private const float BreathHeight = 0.009f;
    private const float ShiftFraction = 0.5f;
    private const float ShiftRoll = 0.068f;

    /// <summary>Yaw of the pelvis to the side that carries the weight; chest and head stay.</summary>
    private const float ShiftYaw = 0.035f;

    /// <summary>Part of the time on one side that it takes to get there.</summary>
    private const float ShiftTime = 0.3f;

    /// <summary>When a hind foot comes to rest and stands flat again, parts of the time on the other side, and how long that takes: it carries again before the weight comes back.</summary>
    private const float RestFrom = 0.28f;
    private const float RestUntil = 0.8f;
    private const float RestTime = 0.18f;

    /// <summary>Share of the shift on legs out to the side, and on more than two pairs.</summary>
    private const double WideLegs = 0.4;

    private const double ManyLegs = 0.2;

    private const float TailSwing = 0.26f;

    /// <summary>How much less the tail swings while the weight is on the right.</summary>
    private const float TailCalm = 0.45f;

    /// <summary>How far folded wings go off the flank with a breath, and as they are shaken into place once in a period, radians; when that begins and how long it takes, parts of the time on the right.</summary>
    private const double WingBreath = 0.012;
    private const double WingShuffle = 0.16;
    private const double ShuffleFrom = 0.45;
    private const double ShuffleTime = 0.24;

    /// <summary>The idle motion at a time.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="seconds">Since the creature came to be.</param>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="weight">A factor on all of it.</param>
    public static IdlePose At(LeggedBody body, double seconds, float activity, float weight)
    {
        double still = (1 - activity) * weight;
        double place = seconds / body.Idle.Period;
        place -= Math.Floor(place);
        double breath = Wave(place * body.Idle.Breaths);
        double rise = breath * BreathHeight * body.LegLength * weight * (1 - (0.7 * activity));
        double half = place < 0.5 ? 2 * place : (2 * place) - 1;
        double ease = Scalar.Smoother(half / ShiftTime);
        double side = ((2 * ease) - 1) * (place < 0.5 ? 1 : -1);
        double spread = body.Rows > 2 ? ManyLegs : body.Legs[0].Lateral ? WideLegs : 1;
        double sway = Wave(place * body.Idle.TailSwings) * TailSwing * (1 - (TailCalm * 0.5 * (1 - side))) * still;
        double shift = side * spread * still * body.ShiftWeight;
        double wings = (WingBreath * (1 + breath) * weight) + (WingShuffle * Bump((half - ShuffleFrom) / ShuffleTime) * (place < 0.5 ? 0 : still));
        double rest = place < 0.5 ? (Scalar.Smoother((half - RestFrom) / RestTime) - Scalar.Smoother((half - RestUntil) / RestTime)) * still : 0;
        return new IdlePose((float)rise, (float)(ShiftFraction * body.HalfTrack * shift), (float)(ShiftRoll * shift), (float)(ShiftYaw * shift), (float)sway, (float)wings, (float)rest);
    }

    /// <summary>Up to 1 and back between 0 and 1, twice and less high the second time.</summary>
    private static double Bump(double x)
    {
        if (x <= 0 || x >= 1)
        {
            return 0;
        }

        double first = Scalar.Smoother(x / 0.3) - Scalar.Smoother((x - 0.3) / 0.3);
        double second = Scalar.Smoother((x - 0.5) / 0.25) - Scalar.Smoother((x - 0.75) / 0.25);
        return first + (0.5 * second);
    }

    private static double Wave(double turns)
    {
        FastTrigonometry.OfTurns((float)(turns - Math.Floor(turns)), out float sine, out _);
        return sine;
    }
}
