using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>What a foot does beside going from place to place.</summary>
/// <param name="Pitch">Radians, toes down.</param>
/// <param name="Fold">Of the metatarsus beyond its link to the thigh, radians.</param>
/// <param name="Load">0 in the air, about 1 in the middle of stance.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly record struct FootPosture(float Pitch, float Fold, float Load)
{
    private const float MaxLoad = 1.2f;

    /// <summary>A posture away from another.</summary>
    public static FootPosture operator -(FootPosture a, FootPosture b) => new(a.Pitch - b.Pitch, a.Fold - b.Fold, a.Load - b.Load);

    /// <summary>A posture with a share of a difference.</summary>
    public FootPosture With(FootPosture difference, float fraction) =>
        new(Pitch + (difference.Pitch * fraction), Fold + (difference.Fold * fraction), Scalar.Clamp(Load + (difference.Load * fraction), 0f, MaxLoad));
}

/// <summary>
/// Carries a foot over from one posture to another. The posture follows from the place in the cycle; where a foot leaves the cycle, or is taken into it, in the middle of a stance or of a swing, the posture
/// that it is in is not that of the place it goes on from: what differs fades.
/// </summary>
internal struct PostureFade
{
    /// <summary>Seconds of a leg of <see cref="TimedLength"/>: a third of its swing in a walk.</summary>
    private const float Time = 0.15f;
    private const float TimedLength = 0.5f;
    private const float ShortestTime = 0.08f;
    private const float LongestTime = 0.3f;

    /// <summary>Radians per second at which a foot pitches at most: where a change of gait hurries its stance on, it would be thrown up.</summary>
    private const float FastestPitch = 28f;

    private FootPosture difference;
    private float fraction;
    private float age;
    private bool begins;

    /// <summary>The posture that was shown last.</summary>
    public FootPosture Shown { get; private set; }

    /// <summary>Seconds that a leg takes.</summary>
    /// <param name="legLength">Metres.</param>
    public static float SecondsOf(float legLength) => Scalar.Clamp(Time * (float)Math.Sqrt(legLength / TimedLength), ShortestTime, LongestTime);

    /// <summary>Tells that the next posture does not follow on the last.</summary>
    public void Begin() => begins = true;

    /// <summary>Goes on to a posture.</summary>
    /// <param name="posture">By the place in the cycle.</param>
    /// <param name="seconds">That a difference takes to fade.</param>
    /// <param name="dt">Seconds since the last one.</param>
    /// <returns>What is shown.</returns>
    public FootPosture Follow(FootPosture posture, float seconds, float dt)
    {
        if (begins)
        {
            begins = false;
            difference = Shown - posture;
            age = 0f;
            fraction = 1f;
        }
        else if (fraction > 0f)
        {
            age += dt;
            fraction = 1f - Scalar.Smooth(age / seconds);
        }

        FootPosture next = fraction > 0f ? posture.With(difference, fraction) : posture;
        float max = dt > 0f ? FastestPitch * dt : float.MaxValue;
        Shown = next with { Pitch = Shown.Pitch + Scalar.Clamp(next.Pitch - Shown.Pitch, -max, max) };
        return Shown;
    }
}
