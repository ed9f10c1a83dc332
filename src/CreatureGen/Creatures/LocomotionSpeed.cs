using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Seeding;

namespace CreatureGen.Creatures;

/// <summary>The speed that a creature moves at when nothing asks for another: a comfortable one for its size.</summary>
internal static class LocomotionSpeed
{
    /// <summary>Froude number of a comfortable walk, well below the change to a trot at 0.35 (Griffin et al. 2004).</summary>
    private const double WalkingFroude = 0.12;

    /// <summary>Speed of a flier that cruises, in √(g·length).</summary>
    private const double FlyingFroude = 1.6;

    /// <summary>Body lengths per second of a snake that crawls.</summary>
    private const double CrawlingLengths = 0.35;

    /// <summary>Power of the body length in the speed of a swimmer that cruises: tempo falls with L to the power −0.55, and a beat takes it a part of its length on.</summary>
    private const double SwimmingPower = 0.45;

    /// <summary>By how much an individual is faster or slower than others of its size at most.</summary>
    private const double PaceSpread = 0.12;

    /// <summary>Metres per second: that of its size, and of the pace that is its own.</summary>
    public static float Of(CreatureBlueprint blueprint, FinishedRig rig)
    {
        double legs = 0;
        double front = double.MinValue;
        double rear = double.MaxValue;
        foreach (Joint joint in rig.Skeleton.Joints)
        {
            front = Math.Max(front, joint.ModelPosition.Z);
            rear = Math.Min(rear, joint.ModelPosition.Z);
        }

        foreach (LimbChain limb in rig.Limbs)
        {
            if (limb.Kind == LimbKind.Leg && limb.Stands)
            {
                legs = Math.Max(legs, rig.Skeleton.Joints[limb.Joints[1]].ModelPosition.Y);
            }
        }

        double length = front - rear;
        double gravity = StandardGravity.Acceleration;
        double speed = blueprint.Kind switch
        {
            LocomotionKind.Walking when legs > 0 => OnLegs(legs),
            LocomotionKind.Walking => CrawlingLengths * length,
            LocomotionKind.Flying => Math.Sqrt(gravity * length) * FlyingFroude,
            _ => UnitSwimmer(blueprint.Plan) * PortableMath.Pow(length, SwimmingPower),
        };
        return (float)(speed * Pace(blueprint));
    }

    /// <summary>Metres per second of a walk on legs of a length, metres.</summary>
    internal static double OnLegs(double length) => Math.Sqrt(WalkingFroude * StandardGravity.Acceleration * length);

    /// <summary>Speed of cruise of a swimmer of one metre, m/s.</summary>
    private static double UnitSwimmer(BodyPlan plan) => plan switch
    {
        BodyPlan.Eel => 0.66,
        BodyPlan.Whale => 0.78,
        BodyPlan.Flipper => 0.9,
        _ => 0.86,
    };

    /// <summary>No two individuals of a species have the same pace.</summary>
    private static double Pace(CreatureBlueprint blueprint) =>
        1 + new Seed(blueprint.Seed).Child("pace").Child(blueprint.Coat.Marks).Stream().Uniform(-PaceSpread, PaceSpread);
}
