using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>How quickly a speed may change.</summary>
/// <param name="Rise">Most that it gains in a second.</param>
/// <param name="Fall">Most that it loses in a second.</param>
/// <param name="Lag">Seconds with which the body follows what the creature intends, above 0: the force is not there at once.</param>
internal readonly record struct SpeedBounds(float Rise, float Fall, float Lag);

/// <summary>
/// A speed that goes over to what is asked with bounded acceleration and without a jump of it: what the creature intends goes to the goal at a bounded rate, and the body follows its intention with a lag.
/// </summary>
/// <remarks>
/// Solved in closed form, r being the intention with slope s, τ the lag: v(t) = r(t) − sτ + (v₀ − r₀ + sτ) e^(−t/τ). So where the body is after a time does not depend on how the time is cut into steps,
/// and what is foretold is what comes.
/// </remarks>
internal struct IntendedSpeed
{
    /// <summary>Difference below which the goal is reached, part of it and metres or radians per second.</summary>
    private const float Reached = 1e-5f;

    private float intention;

    /// <summary>At present.</summary>
    public float Speed { get; private set; }

    /// <summary>What it is going over to.</summary>
    public float Goal { get; private set; }

    /// <summary>A steady speed.</summary>
    public static IntendedSpeed At(float speed) => new() { intention = speed, Speed = speed, Goal = speed };

    /// <summary>Whether nothing changes.</summary>
    public readonly bool IsSteady
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Speed == Goal && intention == Goal;
    }

    /// <summary>Change of the speed per second.</summary>
    /// <param name="bounds">By which it goes.</param>
    public readonly float Acceleration(in SpeedBounds bounds) => (intention - Speed) / bounds.Lag;

    /// <summary>Asks for a speed.</summary>
    public void Ask(float goal) => Goal = goal;

    /// <summary>Changes the speed at once; what is intended stays.</summary>
    public void Push(float change) => Speed += change;

    /// <summary>Goes on for a time.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="bounds">How quickly it may change.</param>
    /// <returns>Its mean meanwhile.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Advance(float dt, in SpeedBounds bounds) => IsSteady || !(dt > 0f) ? Speed : GoOver(dt, bounds);

    private float GoOver(float dt, in SpeedBounds bounds)
    {
        float way = 0f;
        float left = dt;
        while (left > 0f && intention != Goal)
        {
            // Down to nothing first where it changes sides.
            bool falls = intention != 0f && (intention > 0f ? Goal < intention : Goal > intention);
            float end = falls && intention * Goal < 0f ? 0f : Goal;
            float slope = falls ? bounds.Fall : bounds.Rise;
            float time = Math.Abs(end - intention) / slope;
            if (time <= left)
            {
                way += Follow(end > intention ? slope : -slope, time, bounds.Lag);
                intention = end;
                left -= time;
            }
            else
            {
                slope = end > intention ? slope : -slope;
                way += Follow(slope, left, bounds.Lag);
                intention += slope * left;
                left = 0f;
            }
        }

        way += Follow(0f, left, bounds.Lag);
        if (intention == Goal && Math.Abs(Speed - Goal) <= Reached * (1f + Math.Abs(Goal)))
        {
            Speed = Goal;
        }

        return way / dt;
    }

    /// <summary>Follows an intention that changes steadily.</summary>
    /// <returns>Integral of the speed.</returns>
    private float Follow(float slope, float time, float lag)
    {
        float behind = slope * lag;
        float away = Speed - intention + behind;

        // One that goes as it intends, as most do, has nothing of which a part could be kept.
        float keep = away == 0f ? 0f : (float)PortableMath.Exp(-time / lag);
        Speed = intention + (slope * time) - behind + (away * keep);
        return ((intention - behind + (0.5f * slope * time)) * time) + (away * lag * (1f - keep));
    }
}
