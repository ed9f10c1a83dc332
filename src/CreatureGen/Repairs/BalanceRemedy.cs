using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Json;
using CreatureGen.Rigging;

namespace CreatureGen.Repairs;

/// <summary>Brings the centre of mass over the feet: the feet of the end that it leans over go its way, then their hips, later what is too heavy there gets lighter.</summary>
internal static class BalanceRemedy
{
    /// <summary>Part of what is missing that feet are moved by at a time.</summary>
    private const double Step = 0.6;

    /// <summary>Farthest lean of a leg, in units of its length.</summary>
    private const double MaxShear = 0.9;

    /// <summary>Rounds of moving feet alone.</summary>
    private const int FeetRounds = 3;

    /// <summary>Radians by which a splayed leg is turned at a time, and the farthest from straight aside.</summary>
    private const double Turn = 0.2;
    private const double MaxTurn = 1.2;

    /// <summary>Rings of the body by which a hip is moved at a time.</summary>
    private const int HipRings = 2;

    /// <summary>Radians by which the front of a body that lies is raised at a time, and the farthest.</summary>
    private const double NeckLift = 0.08;
    private const double MaxRaised = 1.4;

    /// <summary>What rump and tail grow by at a time as a counterweight, and how far.</summary>
    private const double RearGrowth = 1.05;
    private const double MaxGrown = 1.5;

    private const double HeadKept = 0.9;
    private const double TailKept = 0.88;
    private const double FootGrowth = 1.12;

    /// <summary>Changes the blueprint. False if nothing is left to try.</summary>
    public static bool Apply(RepairLog log, Creature creature, int round)
    {
        CreatureBlueprint b = log.Blueprint;
        (double rear, double front) = FeetOf(creature);
        double mass = creature.Mass.Centre.Z;
        double middle = rear <= front ? (rear + front) / 2 : 0;
        bool ahead = mass > middle;
        if (rear > front)
        {
            return RearUp(log, round);
        }

        // How far the mass must go inwards from the nearer end, with a fifth of the base to spare.
        double over = ahead ? mass - front : rear - mass;
        double missing = (Math.Max(over, 0) + Math.Max(0.12 * (front - rear), 0.03 * creature.StandingHeight)) / b.Scale;
        bool changed = log.Change(b with { Legs = MoveFeet(b.Legs, ahead, missing, b.Body.Elevation) }, Reason(ahead, over / b.Scale));
        if (round < FeetRounds && changed)
        {
            return true;
        }

        bool moved = MoveHips(log, ahead);
        return Lighten(log, ahead) || changed || moved;
    }

    private static string Reason(bool ahead, double over) =>
        "the centre of mass was " + NumberText.Of(Math.Round(Math.Abs(over), 3)) + (over > 0 ? " m beyond" : " m inside") + (ahead ? " the front feet" : " the hind feet") + " at scale 1";

    /// <summary>Where the hindmost and the foremost standing foot are along z; the first is greater if none stands.</summary>
    private static (double Rear, double Front) FeetOf(Creature creature)
    {
        double rear = double.PositiveInfinity, front = double.NegativeInfinity;
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Stands)
            {
                rear = Math.Min(rear, limb.Contact.Z);
                front = Math.Max(front, limb.Contact.Z);
            }
        }

        return (rear, front);
    }

    /// <summary>The standing pair that is farthest to the front or to the rear; -1 if none stands.</summary>
    private static int EndOf(ValueList<LegBlueprint> legs, bool ahead)
    {
        int end = -1;
        for (int i = 0; i < legs.Count; i++)
        {
            bool farther = end < 0 || (ahead ? legs[i].Socket.Ring < legs[end].Socket.Ring : legs[i].Socket.Ring > legs[end].Socket.Ring);
            end = legs[i].Stance == LegStance.Standing && farther ? i : end;
        }

        return end;
    }

    /// <summary>Legs that lean as far as they may grow out of the body nearer to its mass, where there is room.</summary>
    private static bool MoveHips(RepairLog log, bool ahead)
    {
        CreatureBlueprint b = log.Blueprint;
        int end = EndOf(b.Legs, ahead);
        if (end < 0 || (ahead ? b.Legs[end].Shear : -b.Legs[end].Shear) < MaxShear)
        {
            return false;
        }

        LegBlueprint leg = b.Legs[end];
        SocketBlueprint socket = leg.Socket with { Ring = leg.Socket.Ring + (ahead ? -HipRings : HipRings) };
        CreatureBlueprint moved = b with { Legs = b.Legs.With(end, leg with { Socket = socket }) };
        return BlueprintValidator.Validate(moved).Count == 0 && log.Change(moved, "its legs grew too far " + (ahead ? "behind" : "before") + " its centre of mass");
    }

    private static ValueList<LegBlueprint> MoveFeet(ValueList<LegBlueprint> legs, bool ahead, double missing, double height)
    {
        int end = EndOf(legs, ahead);
        if (end < 0)
        {
            return legs;
        }

        LegBlueprint leg = legs[end];
        double shift = Step * missing / Math.Max(height, 0.05);
        double shear = Math.Min(MaxShear, Math.Max(-MaxShear, leg.Shear + (ahead ? shift : -shift)));
        double foot = Math.Min(2.2, FootGrowth * leg.FootSize);
        double turn = Splayed(leg) ? (ahead ? Turn : -Turn) : 0;
        double azimuth = Math.Min(MaxTurn, Math.Max(-MaxTurn, leg.Azimuth + turn));
        return legs.With(end, leg with { Shear = shear, FootSize = foot, Azimuth = azimuth });
    }

    private static bool Splayed(LegBlueprint leg) => LegKinds.Of(leg.Archetype) is { Build.Posture: LimbPosture.Splayed, Outline.Crouched: false };

    /// <summary>A body that lies on its trunk tips over when what it raises is too heavy: the front goes up and gets lighter, later the chest too, and the rear heavier.</summary>
    private static bool RearUp(RepairLog log, int round)
    {
        BodyBlueprint body = log.Blueprint.Body;
        bool late = round >= FeetRounds;
        BodyPosture posture = body.Posture with { Neck = Math.Min(MaxRaised, body.Posture.Neck + (late ? 2 * NeckLift : NeckLift)), NeckBend = 0.8 * body.Posture.NeckBend };
        BodyProportions p = body.Proportions;
        BodyProportions lighter = p with { Head = 0.94 * p.Head, Neck = 0.96 * p.Neck };
        BodyProportions shifted = lighter with { Chest = 0.96 * p.Chest, Rump = Grown(p.Rump), Tail = Grown(p.Tail), TailGirth = Grown(p.TailGirth) };
        return log.Change(log.Blueprint with { Body = body with { Posture = posture, Proportions = late ? shifted : lighter } }, "it tipped over its raised front");
    }

    private static double Grown(double fraction) => Math.Max(fraction, Math.Min(MaxGrown, RearGrowth * fraction));

    private static bool Lighten(RepairLog log, bool ahead)
    {
        BodyBlueprint body = log.Blueprint.Body;
        BodyProportions p = body.Proportions;
        BodyProportions lighter = ahead
            ? p with { Head = HeadKept * p.Head, Neck = 0.95 * p.Neck, NeckGirth = 0.95 * p.NeckGirth }
            : p with { Tail = TailKept * p.Tail, TailGirth = 0.94 * p.TailGirth, Rump = 0.97 * p.Rump };
        return log.Change(log.Blueprint with { Body = body with { Proportions = lighter } }, ahead ? "head and neck weighed the front down" : "the tail weighed the rear down");
    }
}
