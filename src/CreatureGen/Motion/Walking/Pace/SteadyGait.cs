using System;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>The numbers of a gait for which something has been worked out: while they are the same it need not be done again.</summary>
internal struct SteadyGait
{
    private readonly float[] lags;
    private float duty;
    private float track;

    /// <summary>That of a body with so many legs; nothing has been worked out yet.</summary>
    public SteadyGait(int legs)
    {
        lags = new float[legs];
        duty = float.NaN;
        track = 0f;
    }

    /// <summary>Whether a clock still has the numbers that were taken.</summary>
    public readonly bool Is(GaitClock clock) => clock.Duty == duty && clock.Shape.Track == track && clock.Lags.SequenceEqual(lags);

    /// <summary>Takes the numbers of a clock.</summary>
    public void Take(GaitClock clock)
    {
        duty = clock.Duty;
        track = clock.Shape.Track;
        clock.Lags.CopyTo(lags);
    }
}
