using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>What is remembered of one spring bone, side by side in memory. World axes, world metres, places from the creature's place.</summary>
internal struct SpringBone
{
    /// <summary>From the goal of its tip to the tip.</summary>
    public Vector3 Offset;

    /// <summary>The same at the moment of the frame, where that was after the last substep.</summary>
    public Vector3 OffsetShown;

    /// <summary>Velocity of its tip relative to the goal.</summary>
    public Vector3 Velocity;

    /// <summary>Goal of its tip in the last substep.</summary>
    public Vector3 Goal;

    /// <summary>Velocity of the goal in the last substep.</summary>
    public Vector3 GoalVelocity;

    /// <summary>Where the animation had it at the last update.</summary>
    public SpringAim Past;
}
