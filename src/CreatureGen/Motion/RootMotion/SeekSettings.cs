using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>How a creature goes to a target and keeps its distance.</summary>
public readonly struct SeekSettings
{
    /// <summary>Sets the manners.</summary>
    /// <param name="speed">Metres per second ahead, not negative.</param>
    /// <param name="turnSpeed">Radians per second, not negative.</param>
    /// <param name="near">Metres; a target nearer than this is backed away from.</param>
    /// <param name="far">Metres; a target farther than this is approached; above <paramref name="near"/>.</param>
    /// <param name="turnBeyond">Radians off ahead at which turning begins.</param>
    /// <param name="facing">Radians off ahead at which turning ends; below <paramref name="turnBeyond"/>.</param>
    /// <param name="moveWithin">Radians off ahead within which it walks; beyond, it turns on the spot first.</param>
    /// <param name="retreatFraction">Speed backwards, share of that ahead.</param>
    /// <exception cref="ArgumentException">A number is outside its range or not a number.</exception>
    public SeekSettings(float speed, float turnSpeed = 1.745f, float near = 4.5f, float far = 6f, float turnBeyond = 0.35f, float facing = 0.05f, float moveWithin = 1.5708f, float retreatFraction = 0.66f)
    {
        Finite.RequireWithin(speed, 0f, 1e6f, nameof(speed));
        Finite.RequireWithin(turnSpeed, 0f, 1e3f, nameof(turnSpeed));
        Finite.RequireWithin(near, 0f, 1e6f, nameof(near));
        Finite.RequireWithin(far, near, 1e6f, nameof(far));
        Finite.RequireWithin(turnBeyond, 1e-4f, 3.1416f, nameof(turnBeyond));
        Finite.RequireWithin(facing, 0f, turnBeyond, nameof(facing));
        Finite.RequireWithin(moveWithin, 1e-3f, 3.1416f, nameof(moveWithin));
        Finite.RequireWithin(retreatFraction, 0f, 1f, nameof(retreatFraction));
        Speed = speed;
        TurnSpeed = turnSpeed;
        Near = near;
        Far = far;
        TurnBeyond = turnBeyond;
        Facing = facing;
        MoveWithin = moveWithin;
        RetreatFraction = retreatFraction;
    }

    /// <summary>2 m/s, 100°/s, between 4.5 and 6 m.</summary>
    public static SeekSettings Default { get; } = new(2f);

    /// <summary>Metres per second ahead.</summary>
    public float Speed { get; }

    /// <summary>Radians per second.</summary>
    public float TurnSpeed { get; }

    /// <summary>Metres.</summary>
    public float Near { get; }

    /// <summary>Metres.</summary>
    public float Far { get; }

    /// <summary>Radians.</summary>
    public float TurnBeyond { get; }

    /// <summary>Radians.</summary>
    public float Facing { get; }

    /// <summary>Radians.</summary>
    public float MoveWithin { get; }

    /// <summary>Share of the speed.</summary>
    public float RetreatFraction { get; }
}
