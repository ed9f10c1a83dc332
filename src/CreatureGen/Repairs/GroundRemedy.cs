using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Repairs;

/// <summary>Brings the lowest point of a creature onto the ground: raises head or tail or shortens arms if these hang too low, else raises the body; its legs grow with it.</summary>
internal static class GroundRemedy
{
    /// <summary>Metres that a raised part clears the ground by.</summary>
    private const double Clearance = 0.012;

    /// <summary>Radians by which a tail and a neck are raised at a time.</summary>
    private const double TailLift = 0.12;
    private const double NeckLift = 0.1;

    /// <summary>Part of its length that a hanging arm keeps.</summary>
    private const double ArmKept = 0.85;

    /// <summary>Rounds after which a part that hangs low has been tried for long enough, and the whole body is raised.</summary>
    private const int PartRounds = 10;

    /// <summary>Changes the blueprint. False if nothing is left to try.</summary>
    public static bool Apply(RepairLog log, Creature creature, int round)
    {
        (float lowest, JointRole role) = LowestOf(creature);
        double depth = -lowest / log.Blueprint.Scale;
        CreatureBlueprint b = log.Blueprint;
        if (depth < 0 || Math.Abs(lowest) <= Tolerance.GroundMetres)
        {
            return depth < 0 && StandsOnNothing(creature) ? Raise(log, depth, "nothing of it touched the ground") : RefitFeet(log);
        }

        string reason = "the lowest point was " + NumberText.Of(Math.Round(depth, 3)) + " m below the ground at scale 1";
        bool small = depth < 0.04 * b.Body.Elevation;
        if (small || round >= PartRounds)
        {
            return Raise(log, depth + Clearance, reason);
        }

        bool changed = role switch
        {
            JointRole.Tail => LiftTail(log),
            JointRole.Head or JointRole.Neck or JointRole.Jaw or JointRole.Eye or JointRole.Lid or JointRole.Ear or JointRole.Antenna => LiftNeck(log),
            JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball or JointRole.End => ShortenArms(log),
            _ => false,
        };
        return changed || Raise(log, depth + Clearance, reason);
    }

    private static bool LiftTail(RepairLog log)
    {
        BodyBlueprint body = log.Blueprint.Body;
        double bend = body.Posture.TailBend > 0 ? 0.7 * body.Posture.TailBend : body.Posture.TailBend;
        return log.Change(log.Blueprint with { Body = body with { Posture = body.Posture with { Tail = body.Posture.Tail - TailLift, TailBend = bend } } }, "the tail hung below the ground");
    }

    private static bool LiftNeck(RepairLog log)
    {
        BodyBlueprint body = log.Blueprint.Body;
        return log.Change(log.Blueprint with { Body = body with { Posture = body.Posture with { Neck = body.Posture.Neck + NeckLift } } }, "the head hung below the ground");
    }

    private static bool Raise(RepairLog log, double metres, string reason)
    {
        CreatureBlueprint b = log.Blueprint;
        return log.Change(b with { Body = b.Body with { Elevation = b.Body.Elevation + metres } }, reason);
    }

    private static bool ShortenArms(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        ValueList<LegBlueprint> legs = b.Legs.Each(leg => leg.Stance == LegStance.Hanging ? leg with { Length = ArmKept * leg.Length, Reach = ArmKept * leg.Reach } : leg);
        return log.Change(b with { Legs = legs }, "the arms hung below the ground");
    }

    /// <summary>Feet that are too large for their legs end below or above the ground.</summary>
    private static bool RefitFeet(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        ValueList<LegBlueprint> legs = b.Legs.Each(leg => leg.Stance == LegStance.Standing ? Plainer(leg) : leg);
        double elevation = 1.05 * b.Body.Elevation;
        return log.Change(b with { Legs = legs, Body = b.Body with { Elevation = elevation } }, "a foot did not end on the ground");
    }

    private static LegBlueprint Plainer(LegBlueprint leg) => leg with
    {
        FootSize = Toward(leg.FootSize, 1),
        Stoutness = Toward(leg.Stoutness, 1),
        Slimness = Toward(leg.Slimness, 1),
        Thickness = 0.92 * leg.Thickness,
        Shear = 0.8 * leg.Shear,
        KneeRise = Toward(leg.KneeRise, 1),
    };

    private static double Toward(double value, double goal) => value + (0.3 * (goal - value));

    private static bool StandsOnNothing(Creature creature)
    {
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Stands)
            {
                return false;
            }
        }

        return true;
    }

    private static (float Lowest, JointRole Role) LowestOf(Creature creature)
    {
        ReadOnlySpan<System.Numerics.Vector3> positions = creature.Mesh.Positions;
        int lowest = 0;
        for (int v = 1; v < positions.Length; v++)
        {
            lowest = positions[v].Y < positions[lowest].Y ? v : lowest;
        }

        IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
        return (positions[lowest].Y, joints[creature.Mesh.Weights[lowest].Joint0].Role);
    }
}
