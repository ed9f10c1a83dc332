using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>A swing to and fro in the course of a phase: chewing, wagging, trembling. It grows from nothing and dies away within the phase.</summary>
/// <param name="Channel">What swings.</param>
/// <param name="Size">How far to either side, in the channel's unit.</param>
/// <param name="Cycles">Whole swings in the phase, 0..100.</param>
/// <param name="Lag">By which part of a swing it is late, −1..1.</param>
public readonly record struct ActWave(ActChannel Channel, float Size, float Cycles, float Lag = 0f)
{
    /// <summary>Part of a phase in which a wave grows, and in which it dies away.</summary>
    private const float Fade = 0.18f;

    /// <summary>How far it is out.</summary>
    /// <param name="at">Place in the phase, 0..1; of phases that last, beyond.</param>
    /// <param name="lasts">Whether the phase has no end.</param>
    internal float At(double at, bool lasts)
    {
        double turns = (Cycles * at) - Lag;
        FastTrigonometry.OfTurns((float)(turns - Math.Floor(turns)), out float sine, out _);
        double weight = Scalar.Smooth(Scalar.Clamp(at / Fade, 0, 1)) * (lasts ? 1 : Scalar.Smooth(Scalar.Clamp((1 - at) / Fade, 0, 1)));
        return Size * sine * (float)weight;
    }
}
