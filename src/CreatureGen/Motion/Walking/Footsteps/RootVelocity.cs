using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>How the body moves over the ground, in its own axes, and what it is going over to.</summary>
internal struct RootVelocity
{
    /// <summary>Metres per second ahead.</summary>
    public float Speed;

    /// <summary>Metres per second to the left.</summary>
    public float Sideways;

    /// <summary>Radians per second to the left.</summary>
    public float Turn;

    public float GoalSpeed;
    public float GoalSideways;
    public float GoalTurn;

    /// <summary>Sharpness with which the goal is approached, per second; 0 when the game moves the body itself.</summary>
    public float Rate;

    /// <summary>Goes on for a time, and tells the way gone meanwhile.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="yaw">Turn in that time, radians.</param>
    /// <returns>Displacement in the axes at the start.</returns>
    public Vector3 Advance(float dt, out float yaw)
    {
        float keep = (float)PortableMath.Exp(-Rate * dt);
        float mean = Rate * dt > 1e-4f ? (1f - keep) / (Rate * dt) : 1f;
        float ahead = GoalSpeed + ((Speed - GoalSpeed) * mean);
        float left = GoalSideways + ((Sideways - GoalSideways) * mean);
        float turn = GoalTurn + ((Turn - GoalTurn) * mean);
        Speed = GoalSpeed + ((Speed - GoalSpeed) * keep);
        Sideways = GoalSideways + ((Sideways - GoalSideways) * keep);
        Turn = GoalTurn + ((Turn - GoalTurn) * keep);
        yaw = turn * dt;
        return Along(ahead, left, turn, dt);
    }

    /// <summary>Where the body will be after a time.</summary>
    public readonly Vector3 Predict(float dt, out float yaw)
    {
        if (Speed == GoalSpeed && Sideways == GoalSideways && Turn == GoalTurn)
        {
            yaw = Turn * dt;
            return Along(Speed, Sideways, Turn, dt);
        }

        float x = Rate * dt;
        float mean = x > 1e-3f ? (1f - (float)PortableMath.Exp(-x)) / x : 1f - (0.5f * x);
        float turn = GoalTurn + ((Turn - GoalTurn) * mean);
        yaw = turn * dt;
        return Along(GoalSpeed + ((Speed - GoalSpeed) * mean), GoalSideways + ((Sideways - GoalSideways) * mean), turn, dt);
    }

    /// <summary>Displacement along an arc at steady speeds.</summary>
    private static Vector3 Along(float ahead, float left, float turn, float dt)
    {
        float angle = turn * dt;
        float a;
        float b;
        if (Math.Abs(angle) < 1e-3f)
        {
            a = dt;
            b = 0.5f * angle * dt;
        }
        else
        {
            PortableMath.SinCos(angle, out double sine, out double cosine);
            a = (float)(sine / turn);
            b = (float)((1 - cosine) / turn);
        }

        return new Vector3((left * a) + (ahead * b), 0f, (ahead * a) - (left * b));
    }
}
