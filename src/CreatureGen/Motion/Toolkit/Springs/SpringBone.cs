using System.Numerics;
using CreatureGen.Maths;

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

    /// <summary>Animated place of its joint at the last update.</summary>
    public Vector3 PastPosition;

    /// <summary>Animated direction to its tip at the last update, unit.</summary>
    public Vector3 PastAlong;

    /// <summary>Animated place now.</summary>
    public Vector3 NowPosition;

    /// <summary>Animated direction now, unit.</summary>
    public Vector3 NowAlong;

    /// <summary>Goal of its tip at the moment of the frame.</summary>
    public Vector3 Shown;

    /// <summary>Square of the greatest speed of its swing as part of the width that is left of it, s⁻².</summary>
    public float Liveliness;

    /// <summary>Part of the velocity through the air that is left after a substep.</summary>
    public float Slowed;

    /// <summary>Part of gravity that it feels.</summary>
    public float GravityFraction;

    /// <summary>What it keeps from colliders, model metres.</summary>
    public float Radius;

    /// <summary>One substep of its spring.</summary>
    public DampedSpring Step;
}
