using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Rigging;

namespace CreatureGen.Creatures;

/// <summary>The speed that a creature moves at when nothing asks for another: a comfortable one for its size.</summary>
internal static class LocomotionSpeed
{
    private const double Gravity = 9.81;

    /// <summary>Froude number of a comfortable walk, well below the change to a trot at 0.35 (Griffin et al. 2004).</summary>
    private const double WalkingFroude = 0.12;

    /// <summary>Body lengths per second of a swimmer that cruises and of a snake that crawls.</summary>
    private const double SwimmingLengths = 0.8;

    private const double CrawlingLengths = 0.35;

    /// <summary>Metres per second.</summary>
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
        return (float)(blueprint.Kind switch
        {
            LocomotionKind.Walking when legs > 0 => Math.Sqrt(WalkingFroude * Gravity * legs),
            LocomotionKind.Walking => CrawlingLengths * length,
            LocomotionKind.Flying => Math.Sqrt(Gravity * length) * 1.6,
            _ => SwimmingLengths * length,
        });
    }
}
