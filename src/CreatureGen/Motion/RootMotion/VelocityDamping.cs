using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Velocity and turn rate that go over to what is asked of them exponentially, and the path that this makes: the same at any frame rate. Nothing is allocated.</summary>
/// <remarks>
/// Both follow v(t) = goal + (v₀ − goal)e^(−kt) exactly, so the heading is θ(t) = goal · t + (ω₀ − goal)(1 − e^(−kt))/k. The path ∫R(θ)v dt has no closed form and is integrated by Gauss's rule of five points over
/// at most 1/16 s, which is exact to float precision. Based on: WeaverDev, "Bonehead" (2018), root motion.
/// </remarks>
public static class VelocityDamping
{
    private const float Longest = 1e6f;
    private const float Fastest = 1e9f;
    private const float FastestTurn = 1e6f;
    private const float LongestPiece = 1f / 16f;
    private const double Inner = 0.53846931010568309;
    private const double Outer = 0.90617984593866399;
    private const double MiddleWeight = 0.28444444444444444;
    private const double InnerWeight = 0.23931433524968324;
    private const double OuterWeight = 0.11846344252809454;

    /// <summary>Lets time pass.</summary>
    /// <param name="velocity">At the beginning of the step, then at its end; up to 10⁹ m/s and 10⁶ rad/s.</param>
    /// <param name="goal">What is asked during the step; as large at most.</param>
    /// <param name="rate">s⁻¹ for the linear velocity, 0 to 10⁶; 5 is lively, 2 is heavy.</param>
    /// <param name="yawDamping">s⁻¹ for the turn rate, 0 to 10⁶.</param>
    /// <param name="seconds">0 to 10⁶.</param>
    /// <returns>How far the creature went.</returns>
    /// <exception cref="ArgumentException">A number is not finite or out of its range.</exception>
    public static RootDelta Advance(ref BodyVelocity velocity, in BodyVelocity goal, float rate, float yawDamping, float seconds)
    {
        Finite.RequireWithin(seconds, 0f, Longest, nameof(seconds));
        Finite.RequireWithin(rate, 0f, 1e6f, nameof(rate));
        Finite.RequireWithin(yawDamping, 0f, 1e6f, nameof(yawDamping));
        Require(velocity, nameof(velocity));
        Require(goal, nameof(goal));
        int pieces = Math.Max(1, (int)Math.Min(Math.Ceiling(seconds / (double)LongestPiece), 4096));
        float piece = seconds / pieces;
        Vector3 shift = Vector3.Zero;
        float turn = 0f;
        for (int i = 0; i < pieces; i++)
        {
            Vector3 part = Path(velocity, goal, rate, yawDamping, piece);
            shift += turn == 0f ? part : Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, turn), part);
            turn += Heading(velocity, goal, yawDamping, piece);
            velocity = new BodyVelocity(
                Damping.Approach(velocity.Linear, goal.Linear, rate, piece),
                Damping.Approach(velocity.YawRate, goal.YawRate, yawDamping, piece));
        }

        return new RootDelta(shift, turn);
    }

    private static void Require(in BodyVelocity velocity, string name)
    {
        Finite.RequireWithin(velocity.Linear, Fastest, name);
        Finite.RequireWithin(velocity.YawRate, -FastestTurn, FastestTurn, name);
    }

    private static float Heading(in BodyVelocity velocity, in BodyVelocity goal, float yawDamping, float seconds) =>
        (goal.YawRate * seconds) + ((velocity.YawRate - goal.YawRate) * Damping.Integral(yawDamping, seconds));

    private static Vector3 Path(in BodyVelocity velocity, in BodyVelocity goal, float rate, float yawDamping, float seconds)
    {
        if (velocity.YawRate == 0f && goal.YawRate == 0f)
        {
            return (goal.Linear * seconds) + ((velocity.Linear - goal.Linear) * Damping.Integral(rate, seconds));
        }

        Vector3 sum = At(velocity, goal, rate, yawDamping, 0.5 * seconds) * (float)MiddleWeight;
        sum += (At(velocity, goal, rate, yawDamping, 0.5 * (1 - Inner) * seconds) + At(velocity, goal, rate, yawDamping, 0.5 * (1 + Inner) * seconds)) * (float)InnerWeight;
        sum += (At(velocity, goal, rate, yawDamping, 0.5 * (1 - Outer) * seconds) + At(velocity, goal, rate, yawDamping, 0.5 * (1 + Outer) * seconds)) * (float)OuterWeight;
        return sum * seconds;
    }

    private static Vector3 At(in BodyVelocity velocity, in BodyVelocity goal, float rate, float yawDamping, double time)
    {
        Vector3 v = Damping.Approach(velocity.Linear, goal.Linear, rate, (float)time);
        return Rotation.Rotate(Rotation.FromAxisAngle(Vector3.UnitY, Heading(velocity, goal, yawDamping, (float)time)), v);
    }
}
