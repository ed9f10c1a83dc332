using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;

namespace CreatureGen.Lab.Runtime;

/// <summary>Where a creature goes.</summary>
internal enum Medium
{
    /// <summary>On legs or on its belly.</summary>
    Ground,

    /// <summary>In the air, always: it has no legs to land on.</summary>
    Air,

    /// <summary>In the water.</summary>
    Water,
}

/// <summary>How large a creature is and how fast it goes.</summary>
/// <param name="Medium">Where it goes.</param>
/// <param name="CanFly">Whether it can take to the air.</param>
/// <param name="Length">Nose to tail at rest, or from side to side where that is more; metres.</param>
/// <param name="Height">Above the ground at rest, metres.</param>
/// <param name="Pace">At ease, metres per second.</param>
/// <param name="Run">In a hurry, metres per second.</param>
/// <param name="FlightSpeed">In the air, metres per second.</param>
internal sealed record Abilities(Medium Medium, bool CanFly, float Length, float Height, float Pace, float Run, float FlightSpeed)
{
    /// <summary>Height over the ground at which it hangs or hovers when it is put somewhere, metres.</summary>
    public float Rise => Medium == Medium.Ground ? 0f : 0.6f * Length;

    public static Abilities Of(MotionProfile profile)
    {
        Creature creature = profile.Subject.Creature!;
        Vector3 least = creature.Mesh.Positions[0];
        Vector3 most = least;
        foreach (ref readonly Vector3 p in creature.Mesh.Positions)
        {
            least.X = Math.Min(least.X, p.X);
            least.Z = Math.Min(least.Z, p.Z);
            most.X = Math.Max(most.X, p.X);
            most.Y = Math.Max(most.Y, p.Y);
            most.Z = Math.Max(most.Z, p.Z);
        }

        float pace = 0f;
        float run = 0f;
        float flight = 0f;
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            float speed = movement.Input.Speed;
            if (movement.Name == "Fly")
            {
                flight = speed;
            }
            else if (movement.Input.Medium == MotionMedium.Ground && movement.Kind == ClipKind.Lasting && speed > 0f)
            {
                pace = pace == 0f ? speed : pace;
                run = movement.Gait != null ? Math.Max(run, Math.Min(speed, 4f * pace)) : pace;
            }
        }

        bool flies = creature.Blueprint.Kind == LocomotionKind.Flying;
        Medium medium = creature.Blueprint.Kind == LocomotionKind.Swimming ? Medium.Water : flies && profile.Gaits == null ? Medium.Air : Medium.Ground;
        return new Abilities(medium, flies, Math.Max(most.Z - least.Z, most.X - least.X), most.Y, pace > 0f ? pace : flight, run > 0f ? run : flight, flight);
    }
}
