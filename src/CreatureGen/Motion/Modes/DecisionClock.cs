namespace CreatureGen.Motion.Modes;

/// <summary>Cuts time at the moments at which it is decided how to go on: so many in a second, however long updates are, so that the same is decided at every frame rate.</summary>
internal struct DecisionClock
{
    /// <summary>Seconds between two decisions of who goes on its feet.</summary>
    public const float Period = 1f / 60f;

    /// <summary>Part of a period that is taken for nothing: updates at the rate of the decisions stay in step with them.</summary>
    private const float Hair = 1e-3f;

    private float since;

    /// <summary>Whether the last step ended with a decision: what is asked is taken up now.</summary>
    public readonly bool Begins => since == 0f;

    /// <summary>Whether it is decided at the end of the step.</summary>
    public bool Decides { get; private set; }

    /// <summary>The next step of time: to the next decision, or to the end of the update.</summary>
    /// <param name="left">Seconds to the end of the update, before and after the step.</param>
    /// <param name="period">Seconds between two decisions, always the same: no step is longer.</param>
    /// <returns>Seconds.</returns>
    public float Next(ref float left, float period = Period)
    {
        float step = period - since;
        Decides = left > step - (Hair * period);
        if (!Decides)
        {
            step = left;
        }
        else if (left < step + (Hair * period))
        {
            step = left;
        }

        since = Decides ? 0f : since + step;
        left -= step;
        return step;
    }
}
